// The context of panels, tools, actions and screens during one build.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include "base/cached_value.h"
#include "edit/commands/command.h"
#include "exchange/own/settings_file.h"
#include "platform/events.h"
#include "ui/context/state.h"
#include "ui/widgets/widgets.h"
#include "world/element.h"
#include "world/element_rows.h"
#include "world/section_columns.h"

namespace coaster::ui {

// --- The key map: the default keys of the table of actions, changed by the user's settings

// An action and its default keys, Key::unknown for none. `name` outlives the map.
struct KeyRow {
  std::string_view name;
  platform::KeyChord first, second;
};

class KeyMap {
 public:
  // Returns the default keys of `rows`, replaced by `choices`. Adds a line to `problems` for each unknown action, each
  // unknown key and each key assigned twice, which leave the row unchanged; also for each default key that moved to
  // another action.
  static KeyMap make(std::span<const KeyRow> rows, std::span<const exchange::KeyBinding> choices,
                     std::vector<std::string>& problems);

  // Returns the keys of an action: none, one or two.
  std::span<const platform::KeyChord> chords(std::string_view action) const;
  // Returns the text of the action's first key; "" if it has none.
  std::string shown(std::string_view action) const;

 private:
  std::vector<std::string_view> names_;
  std::vector<std::vector<platform::KeyChord>> rows_;
};

// Returns the keys as text: "F Ctrl+Z" for `between` " ".
std::string chords_text(std::span<const platform::KeyChord> chords, std::string_view between);

// Returns "HELP Key C.", "HELP Keys Ctrl+Y, Ctrl+Shift+Z.", or the help alone.
std::string with_keys(const KeyMap& keys, std::string_view help, std::string_view action);

struct LabCache;

// A screen or another track that a panel or an action requests. Those up to `quit` ask about unsaved changes first.
struct ScreenRequest {
  enum class Kind {
    nothing,
    replace,
    browse,
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
  std::optional<edit::Command> command = {};  // for replace: one that replaces the track (CommandTraits::replaces)
};

// The last requested change of a section. If it is refused, the reason shows below its field.
struct SectionChangeRequest {
  world::EntityName section;
  std::string parameter;
  std::uint64_t after = 0;  // number of the newest notice before the request
  bool answered = true;
  std::string refusal;
};

// The cell of the table of sections that is being edited.
struct EditedCell {
  world::EntityName section;
  std::optional<world::SectionColumn> column;  // nothing: the first editable cell of its row
  bool begins = true;                          // it does not have the keyboard yet
};

// State of panels between frames. Of the panel Goal:
struct GoalInputs {
  int goal = 0, relation = 0, by = 0;  // selected rows of its lists
  std::optional<double> value;         // in the query's unit; nothing: the present value
  bool together = false;
};

struct PanelState {
  std::string file;                      // the path in Track/File
  double radius = 20;                    // m, the number in Shape/Radius
  std::string_view panel_to_open;        // the panel that an action opens when it shows next; empty: none
  std::string waits_for_key, keys_note;  // settings window: the action that waits for a key press, and what was changed
  std::vector<world::Element> elements = world::usual_elements();  // the elements of the palette, by kind
  world::ElementKind of_forces = world::first_of_forces();         // the force element used last in the palette
  SectionChangeRequest asked;
  std::optional<EditedCell> cell;
  GoalInputs goal;
  // Rows of the table of sections in their order on screen, by the table's serial and the sorting.
  base::CachedValue<std::tuple<std::uint64_t, world::SectionColumn, bool>, std::vector<std::size_t>> section_order;
};

// A part of Build that folds where space is short, unless the user opened or closed it.
struct FoldingPart {
  std::optional<bool> wanted;  // the user's choice, if any
  bool open = true;            // state in this frame
  void toggle() { wanted = !open; }
};
struct FoldingParts {
  FoldingPart parameters, graph;
  bool table = false;  // true: the area shows the table of sections instead of the graph
  // Opens graph or table, or folds the open one.
  void press(bool of_table) {
    if (!graph.open || table == of_table) graph.toggle();
    table = of_table;
  }
};

// Derives from WidgetFrame, so that panels can pass it to widgets.
struct Ui : WidgetFrame {
  const UiState& state;
  Output& out;
  LabCache& lab;
  PanelState& inputs;
  const KeyMap& keys;
  std::string_view renderer;  // GL_RENDERER
  const view::Pick& hovered;  // under the mouse in the previous frame, in the viewport or a plot
  FoldingParts& drawers;
  ScreenRequest want = {};                // handled by the host in the same frame
  bool lesson_begins = false;             // true in the first frames of a lesson
  const Widget* lesson_widget = nullptr;  // the widget that the lesson points at, as last drawn, visible or not
  view::Pick pointed = {};                // the position on the track under the mouse in a plot
  bool finger = false;                    // the mouse is a finger on a touch screen
  const edit::SessionFindings& find = state.find;

  const edit::Session& session() const { return state.session; }
  template <class C>
  void emit(C command) {
    out.commands.push_back(edit::Command(std::move(command)));
  }
  // Emits the command with what a widget returned, if the user changed it.
  template <class C, class T>
  void emit_if(const std::optional<T>& changed) {
    if (changed) emit(C{*changed});
  }
  // Runs a command that replaces the track, or first asks about unsaved changes.
  void replace(edit::Command command) { want = {ScreenRequest::Kind::replace, std::move(command)}; }
  edit::Command new_track() const;  // an empty one, on the land that the user wants for new tracks
  // Calls emit_one for each, as one undo step; a drag is one already.
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

// Returns a seed for a land: another one each time.
std::uint32_t random_seed(const Ui& ui);

// A part of the window: a window over it that cannot be moved.
struct WindowArea {
  const char* id;
  std::string_view panel;                        // names its widgets
  std::optional<ImVec2> padding = ImVec2(0, 0);  // px; nothing: as other windows
  bool raised = false;                           // ground of bars
  ImGuiWindowFlags more = ImGuiWindowFlags_NoScrollbar;
};
// Builds it, unless `area` is less than a pixel wide or high.
void build_area(Ui& ui, const view::Viewport& area, const WindowArea& look, const std::function<void()>& content);

// While it lives, widgets are greyed if the challenge locks the command, and their tooltips give the reason.
class LockedWidgets {
 public:
  LockedWidgets(Ui& ui, std::string_view command);
  ~LockedWidgets();
  LockedWidgets(const LockedWidgets&) = delete;
  LockedWidgets& operator=(const LockedWidgets&) = delete;

 private:
  Ui& ui_;
  std::string before_;
};

}  // namespace coaster::ui
