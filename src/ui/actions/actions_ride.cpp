// The menu Ride.
#include "edit/commands/commands_ride.h"
#include "ui/actions/actions_parts.h"

namespace coaster::ui {
namespace {

using platform::Key;

bool running(const Act& act) { return act.ui.session().motion.state == world::RideState::running; }
void play_pause(Act& act) { running(act) ? act.ui.emit(edit::RidePause{}) : act.ui.emit(edit::RideStart{}); }
void single_step(Act& act) {
  if (running(act)) act.ui.emit(edit::RidePause{});
  act.ui.emit(edit::RideStep{1});
}
bool has_failed_place(const Act& act) { return failed_place(act.ui.session()).has_value(); }
void show_failed_place(Act& act) { show_place(act.ui, *failed_place(act.ui.session())); }

constexpr Action kRideActions[] = {
    {"Play or pause", "Ride", key(Key::space), kInDrag, "Start or pause the ride.", play_pause, rideable},
    {"Single step", "Ride", key(Key::period), kRepeats | kInDrag, "Pause the ride and advance one tick of 1/120 s.",
     single_step, rideable},
    {"Reset", "Ride", shift(Key::r), kInDrag, "Return the carts to their start.", emit<edit::RideStop>, rideable},
    {"Show where it failed", "Ride", key(Key::j), kInDrag,
     "Go to where the last ride or its challenge failed and select the segment.", show_failed_place, has_failed_place},
    {"Score cards", "Ride", kNoKey, kInDrag, "Show a card with results at the end of a ride.",
     toggle<&world::Aids::show_card>, always, on<&world::Aids::show_card>},
};

}  // namespace

std::span<const Action> ride_actions() { return kRideActions; }

}  // namespace coaster::ui
