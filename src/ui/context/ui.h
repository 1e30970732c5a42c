// What panels, tools, actions and screens work with during one build.
#pragma once

#include <string>
#include <string_view>
#include <utility>

#include "ui/context/key_map.h"
#include "ui/context/output.h"
#include "ui/context/state.h"
#include "ui/widgets/widgets.h"

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
    settings,
    challenges,
    start_screen
  } kind = Kind::nothing;
  std::string path;  // of load and challenge
};

// Is a WidgetFrame, so that panels hand it to widgets as it is.
struct Ui : WidgetFrame {
  const State& state;
  Output& out;
  LabCache& lab;
  std::string& file;  // the path in Track/File
  double& radius;     // the number in Shape/Radius, m
  const KeyMap& keys;
  std::string_view renderer;  // GL_RENDERER
  const view::Pick& hovered;  // what the mouse pointed at in the frame before, in the viewport or a plot
  Want want = {};             // taken by the host in the same frame
  view::Pick pointed = {};    // a place on the track that a plot under the mouse shows

  const edit::Session& session() const { return state.session; }
  const edit::Findings& find(edit::Want wanted) const { return state.find(wanted); }
  template <class C>
  void emit(C command) {
    out.commands.push_back(edit::Command(std::move(command)));
  }
};

}  // namespace coaster::ui
