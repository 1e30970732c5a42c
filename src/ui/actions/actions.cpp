// The table of all actions, joined from those of the menus, and the keys that run them.
#include "ui/actions/actions.h"

#include <algorithm>
#include <variant>
#include <vector>

#include "base/text.h"
#include "ui/actions/actions_parts.h"
#include "ui/tools/fly_keys.h"

namespace coaster::ui {

using platform::Chord;
using platform::Key;
using world::CameraMode;

const world::Name* selected(const Act& act) {
  const edit::Session& session = act.ui.session();
  return session.document.entities.find<world::Name>(session.settings.selected);
}

bool selected_is(const Act& act, world::Kind kind) {
  const world::Name* const name = selected(act);
  return name != nullptr && name->kind == kind;
}

std::span<const Action> actions() {
  static const std::vector<Action> kAll = [] {
    std::vector<Action> all;
    for (const auto rows : {file_actions(), edit_actions(), section_actions(), view_actions(), ride_actions()})
      all.insert(all.end(), rows.begin(), rows.end());
    return all;
  }();
  return kAll;
}

std::vector<KeyRow> key_rows() {
  std::vector<KeyRow> rows;
  for (const Action& action : actions()) rows.push_back({action.name, action.chord, action.other});
  return rows;
}

void run_transform_keys(Act& act, const platform::Events& events) {
  platform::Events others;
  for (const platform::Event& event : events) {
    const auto* const press = std::get_if<platform::KeyPress>(&event);
    if (press && press->down && (press->key == Key::escape || press->modifiers.ctrl)) others.push_back(event);
  }
  act.tool.transform().take_keys(events);
  run_keys(act, others);
}

void run_keys(Act& act, const platform::Events& events, unsigned only) {
  for (const platform::Event& event : events) {
    const auto* press = std::get_if<platform::KeyPress>(&event);
    if (press == nullptr || !press->down || press->key == Key::unknown) continue;
    if (is_fly_key(*press) && act.ui.session().settings.camera_mode == CameraMode::fly) continue;
    const Chord chord{press->key, press->modifiers};
    for (const Action& action : actions()) {
      const auto chords = act.ui.keys.chords(action.name);
      if (std::find(chords.begin(), chords.end(), chord) == chords.end()) continue;
      if (press->repeat && (action.keys & kRepeats) == 0) continue;
      if ((action.keys & only) != only) continue;
      if ((action.keys & kInDrag) == 0 && (act.tool.dragging() || act.ui.gesture.open)) continue;
      if (action.enabled.holds(act)) action.run(act);
      else if (!press->repeat) act.ui.warn(base::sentence(std::string(action.enabled.otherwise)));
    }
  }
}

}  // namespace coaster::ui
