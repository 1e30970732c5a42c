// What panels, tools, actions and screens work with during one build.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include "base/kept.h"
#include "edit/commands/command.h"
#include "ui/context/key_map.h"
#include "ui/context/output.h"
#include "ui/context/state.h"
#include "ui/widgets/widgets.h"
#include "world/element.h"
#include "world/section_columns.h"

namespace coaster::ui {

struct LabCache;

// A screen that a panel or an action asks for. The first six first ask about unsaved changes.
struct Want {
  enum class Kind {
    nothing,
    fresh,
    browse,
    load,
    challenge,
    tutorial,
    quit,
    save,
    save_as,
    save_sections,
    open_sections,
    settings,
    challenges,
    start_screen
  } kind = Kind::nothing;
  std::string path;  // of load and challenge
};

// The last change of a section that was asked for, to show below its field why it was refused.
struct AskedChange {
  world::Name section;
  std::string parameter;
  std::uint64_t after = 0;  // number of the newest notice before it
  bool answered = true;
  std::string refusal;
};

// The cell of the table of sections that is typed in.
struct EditedCell {
  world::Name section;
  std::optional<world::SectionColumn> column;  // nothing: the first of its row that can be typed in
  bool begins = true;                          // it has yet to take the keyboard
};

// What panels keep between frames.
// Of the panel Goal.
struct GoalInputs {
  int goal = 0, relation = 0, by = 0;  // rows of its lists
  std::optional<double> value;         // in the query's unit; nothing: the present one
  bool together = false;
};

struct Inputs {
  std::string file;                      // the path in Track/File
  double radius = 20;                    // m, the number in Shape/Radius
  std::string waits_for_key, keys_note;  // of the settings: the action whose key is to be pressed, what was changed
  std::array<world::Element, base::count_of<world::ElementKind>()> elements =
      world::usual_elements();                                    // the palette's, by kind
  world::ElementKind of_forces = world::ElementKind::force_hill;  // the palette's last one of forces
  AskedChange asked;
  std::optional<EditedCell> cell;
  GoalInputs goal;
  // Rows of the table of sections as they are shown, by the table's serial and the sorting.
  base::Kept<std::tuple<std::uint64_t, world::SectionColumn, bool>, std::vector<std::size_t>> section_order;
};

// A part of Build that folds where there is little room, unless the user opened or closed it.
struct Drawer {
  std::optional<bool> wanted;  // by the user
  bool open = true;            // in this frame
  void toggle() { wanted = !open; }
};
struct Drawers {
  Drawer parameters, graph;
  bool table = false;  // the graph's area shows the table of sections
  // Opens graph or table, or folds the one that shows.
  void press(bool of_table) {
    if (!graph.open || table == of_table) graph.toggle();
    table = of_table;
  }
};

// Is a WidgetFrame, so that panels hand it to widgets as it is.
struct Ui : WidgetFrame {
  const State& state;
  Output& out;
  LabCache& lab;
  Inputs& inputs;
  const KeyMap& keys;
  std::string_view renderer;  // GL_RENDERER
  const view::Pick& hovered;  // what the mouse pointed at in the frame before, in the viewport or a plot
  Drawers& drawers;
  Want want = {};                         // taken by the host in the same frame
  bool lesson_begins = false;             // a lesson's first frames
  const Widget* lesson_widget = nullptr;  // what it points at, as last drawn, in sight or not
  view::Pick pointed = {};                // a place on the track that a plot under the mouse shows

  const edit::Session& session() const { return state.session; }
  const edit::Findings& find(edit::Want wanted) const { return state.find(wanted); }
  template <class C>
  void emit(C command) {
    out.commands.push_back(edit::Command(std::move(command)));
  }
  // Calls emit_one for each, as one step of undo; a drag is one already.
  template <class List, class EmitOne>
  void emit_each(const List& all, const EmitOne& emit_one) {
    const bool step = all.size() > 1 && !gesture.open;
    if (step) begin_step();
    for (const auto& one : all) emit_one(one);
    if (step) end_step();
  }
  void begin_step();
  void end_step();
};

}  // namespace coaster::ui
