// Shared parts of the action tables. Each menu has its own file.
#pragma once

#include <span>

#include "ui/actions/actions.h"
#include "world/components.h"

namespace coaster::ui {

std::span<const Action> file_actions();
std::span<const Action> edit_actions();
std::span<const Action> view_actions();
std::span<const Action> ride_actions();

constexpr platform::Chord key(platform::Key k) { return {k, {}}; }
constexpr platform::Chord ctrl(platform::Key k) { return {k, {.ctrl = true}}; }
constexpr platform::Chord shift(platform::Key k) { return {k, {.shift = true}}; }
inline constexpr platform::Chord kNoKey{};

// The name of the active knot, segment or cart; null without one.
const world::Name* selected(const Act& act);

inline bool always(const Act&) { return true; }
inline bool any_selected(const Act& act) { return selected(act) != nullptr; }
bool rideable(const Act& act);  // carts on a track

}  // namespace coaster::ui
