// The menu Ride.
#include "edit/commands/commands_ride.h"
#include "edit/commands/commands_settings.h"
#include "ui/actions/actions_parts.h"
#include "ui/tools/places.h"
#include "world/aids.h"

namespace coaster::ui {
namespace {

using platform::Key;

void play_pause(Act& act) {
  if (act.ui.session().motion.state == world::RideState::running) act.ui.emit(edit::RidePause{});
  else act.ui.emit(edit::RideStart{});
}
void single_step(Act& act) {
  if (act.ui.session().motion.state == world::RideState::running) act.ui.emit(edit::RidePause{});
  act.ui.emit(edit::RideStep{1});
}
void reset(Act& act) { act.ui.emit(edit::RideStop{}); }
bool card_wanted(const Act& act) { return act.ui.session().settings.aids->show_card; }
void toggle_card(Act& act) { act.ui.emit(edit::Set<&world::Aids::show_card>{!card_wanted(act)}); }
bool has_failed_place(const Act& act) { return failed_place(act.ui.session()).has_value(); }
void show_failed_place(Act& act) { show_place(act.ui, *failed_place(act.ui.session())); }

constexpr Action kRideActions[] = {
    {"Play or pause", "Ride", "Space", key(Key::space), kNoKey, false, true, "Start or pause the ride.", rideable,
     nullptr, play_pause},
    {"Single step", "Ride", ".", key(Key::period), kNoKey, true, true,
     "Pause the ride and advance one tick of 1/120 s.", rideable, nullptr, single_step},
    {"Reset", "Ride", "Shift+R", shift(Key::r), kNoKey, false, true, "Return the carts to their start.", rideable,
     nullptr, reset},
    {"Show where it failed", "Ride", "J", key(Key::j), kNoKey, false, true,
     "Go to where the last ride or its challenge failed and select the segment.", has_failed_place, nullptr,
     show_failed_place},
    {"Score cards", "Ride", "", kNoKey, kNoKey, false, true, "Show a card with results at the end of a ride.", always,
     card_wanted, toggle_card},
};

}  // namespace

std::span<const Action> ride_actions() { return kRideActions; }

}  // namespace coaster::ui
