// The commands of the ride: start, pause, stop, step and seek. See command.h.
#pragma once

#include "edit/commands/command_fields.h"

namespace coaster::edit {
COASTER_COMMAND_GROUP(Ride);

struct RideStart {
  COASTER_COMMAND(RideStart, "ride.start", "Start or resume the ride.", Effect::motion);
  COASTER_FIELDS()
};
struct RidePause {
  COASTER_COMMAND(RidePause, "ride.pause", "Pause the ride.", Effect::motion);
  COASTER_FIELDS()
};
struct RideStop {
  COASTER_COMMAND(RideStop, "ride.stop", "Return the trains to their start.", Effect::motion);
  COASTER_FIELDS()
};
struct RideStep {
  int ticks = 1;
  COASTER_COMMAND(RideStep, "ride.step", "Advance a paused ride by some ticks of 1/120 s.", Effect::motion);
  COASTER_FIELDS(visit("", self.ticks))
};
struct RideSeek {
  double to = 0;
  COASTER_COMMAND(
      RideSeek, "ride.seek",
      "Put the selected train, else the first, at a distance from the track's start (m), keeping its energy.",
      Effect::motion);
  COASTER_FIELDS(visit("", self.to))
};

COASTER_COMMAND_LIST(Ride, RideStart, RidePause, RideStop, RideStep, RideSeek);

}  // namespace coaster::edit
