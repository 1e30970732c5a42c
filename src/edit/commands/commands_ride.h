// The commands of the ride: start, pause, stop, step and seek. See command.h.
#pragma once

#include "edit/commands/command_fields.h"

namespace coaster::edit {

struct RideStart {
  COASTER_COMMAND("ride.start", "Let the carts run, from where they are.", Effect::motion);
  COASTER_FIELDS()
};
struct RidePause {
  COASTER_COMMAND("ride.pause", "Hold the carts where they are.", Effect::motion);
  COASTER_FIELDS()
};
struct RideStop {
  COASTER_COMMAND("ride.stop", "Put the carts back to their start.", Effect::motion);
  COASTER_FIELDS()
};
struct RideStep {
  int ticks = 1;
  COASTER_COMMAND("ride.step", "Advance a paused ride by some ticks of 1/120 s.", Effect::motion);
  COASTER_FIELDS(visit("", self.ticks))
};
struct RideSeek {
  double to = 0;
  COASTER_COMMAND(
      "ride.seek",
      "Put the selected cart, else the first, at a distance from the track's start (m), keeping its energy.",
      Effect::motion);
  COASTER_FIELDS(visit("", self.to))
};

}  // namespace coaster::edit
