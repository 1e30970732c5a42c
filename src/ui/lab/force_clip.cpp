#include "ui/lab/force_clip.h"

#include "edit/commands/commands_force.h"
#include "ui/lab/force_axes.h"
#include "world/force.h"

namespace coaster::ui {
namespace {

void copy_from(Ui& ui, const ForceKeys& state, const std::vector<world::ForceKey>& keys, bool all) {
  edit::CopyForceKeys copy{{state.section}, state.channel};
  if (!all) copy.from = copy.to = keys[*state.key].at;
  ui.emit(copy);
}

void paste_into(Ui& ui, ForceKeys& state, const world::ForceProgram& program) {
  const std::vector<world::ForceKey>& keys = program.keys(state.channel);
  double at = 0;
  if (state.key) {
    const double next = *state.key + 1 < keys.size() ? keys[*state.key + 1].at : program.length;
    at = to_step((keys[*state.key].at + next) / 2, steps_of(program, state.channel).at);
  }
  state.inserted = at;
  ui.out.wants_paste = true, ui.out.keys_to = KeysPlace{state.section, state.channel, at};
}

}  // namespace

bool copy_or_paste(Ui& ui, ForceKeys& state, const world::ForceProgram& program, const platform::KeyPress& press) {
  const bool all = press.modifiers.shift;
  if (!press.modifiers.ctrl || press.modifiers.alt) return false;
  const std::vector<world::ForceKey>& keys = program.keys(state.channel);
  if (press.key == platform::Key::c && (all ? !keys.empty() : state.key.has_value()))
    return copy_from(ui, state, keys, all), true;
  if (press.key == platform::Key::v && !all) return paste_into(ui, state, program), true;
  return false;
}

}  // namespace coaster::ui
