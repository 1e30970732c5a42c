// The menu Ride.
#include "ui/actions_parts.h"

namespace coaster::ui {
namespace {

using platform::Key;

void play_pause(Act& act) {
  if (act.ui.session().motion.state == world::RideState::running)
    act.ui.emit(edit::RidePause{});
  else
    act.ui.emit(edit::RideStart{});
}
void single_step(Act& act) {
  if (act.ui.session().motion.state == world::RideState::running) act.ui.emit(edit::RidePause{});
  act.ui.emit(edit::RideStep{1});
}
void reset(Act& act) { act.ui.emit(edit::RideStop{}); }

constexpr Action kActions[] = {
    {"Play or pause", "Ride", "Space", key(Key::space), kNoKey, false, true, "Let the carts run, or hold them.", rideable, nullptr, play_pause},
    {"Single step", "Ride", ".", key(Key::period), kNoKey, true, true, "Hold the carts and advance one tick of 1/120 s.", rideable, nullptr, single_step},
    {"Reset", "Ride", "Shift+R", shift(Key::r), kNoKey, false, true, "Put the carts back to their start.", rideable, nullptr, reset},
};

}  // namespace

std::span<const Action> ride_actions() { return kActions; }

}  // namespace coaster::ui
