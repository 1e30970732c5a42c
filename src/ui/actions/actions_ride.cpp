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
constexpr Condition kFailed{[](const Act& act) { return failed_place(act.ui.session()).has_value(); },
                            "No ride has failed."};
void show_failed_place(Act& act) { show_place(act.ui, *failed_place(act.ui.session())); }

constexpr Action kRideActions[] = {
    {"Play or pause", "Ride", key(Key::space), kInDrag, "Start or pause the ride.", play_pause, kRideable},
    {"Single step", "Ride", key(Key::period), kRepeats | kInDrag, "Pause the ride and advance one tick of 1/120 s.",
     single_step, kRideable},
    {"Reset", "Ride", shift(Key::r), kInDrag, "Return the trains to their start.", emit<edit::RideStop>, kRideable},
    {"Show where it failed", "Ride", key(Key::j), kInDrag,
     "Go to where the last ride or its challenge failed and select the segment.", show_failed_place, kFailed},
    {"Score cards", "Ride", kNoKey, kInDrag, "Show a card with results at the end of a ride.",
     toggle<&world::Aids::show_card>, kAlways, on<&world::Aids::show_card>},
};

}  // namespace

std::span<const Action> ride_actions() { return kRideActions; }

}  // namespace coaster::ui
