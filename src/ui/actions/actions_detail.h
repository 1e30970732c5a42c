// Shared parts of the table of actions.
#pragma once

#include <span>

#include "edit/commands/commands_settings.h"
#include "edit/commands/set_setting.h"
#include "ui/actions/actions.h"
#include "ui/tools/show_places.h"
#include "world/settings_groups.h"

namespace coaster::ui {

std::span<const Action> view_actions();

// Switches the workspace. In the laboratory it also opens the pages.
void choose_workspace(Ui& ui, world::Workspace to);

constexpr platform::KeyChord key(platform::Key k) { return {k, {}}; }
constexpr platform::KeyChord ctrl(platform::Key k) { return {k, {.ctrl = true}}; }
constexpr platform::KeyChord shift(platform::Key k) { return {k, {.shift = true}}; }
constexpr platform::KeyChord ctrl_shift(platform::Key k) { return {k, {.shift = true, .ctrl = true}}; }
inline constexpr platform::KeyChord kNoKey{};

// The name of the active knot, segment, section or cart; null without one.
const world::EntityName* selected(const ActionContext& act);
inline constexpr ActionCondition kAnySelected{[](const ActionContext& act) { return selected(act) != nullptr; },
                                              "Select something first."};
bool selected_is(const ActionContext& act, world::EntityKind kind);
inline constexpr ActionCondition kRideable{[](const ActionContext& act) { return rideable(act.ui.session()); },
                                           "A ride needs a track and a train."};

// Functions of actions that turn a setting on or off, or select one of its values, and the rows of such actions.
template <auto Member>
bool on(const ActionContext& act) {
  return world::value_in<Member>(act.ui.session().settings);
}
template <auto Member>
void toggle(ActionContext& act) {
  act.ui.emit(edit::Set<Member>{!on<Member>(act)});
}
template <auto Member, world::ValueOf<Member> value>
bool is(const ActionContext& act) {
  return world::value_in<Member>(act.ui.session().settings) == value;
}
template <auto Member, world::ValueOf<Member> value>
void set(ActionContext& act) {
  act.ui.emit(edit::Set<Member>{value});
}
template <auto Member>
constexpr Action toggling(std::string_view name, std::string_view menu, std::string_view help,
                          platform::KeyChord chord = kNoKey) {
  return {name, menu, chord, kInDrag, help, toggle<Member>, kAlways, on<Member>};
}
template <auto Member, world::ValueOf<Member> value>
constexpr Action choosing(std::string_view name, std::string_view menu, std::string_view help) {
  return {name, menu, kNoKey, kInDrag, help, set<Member, value>, kAlways, is<Member, value>};
}

}  // namespace coaster::ui
