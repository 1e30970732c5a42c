// The commands of rides and challenges. See command.h.
#pragma once

#include <string>

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

COASTER_COMMAND_GROUP(Challenge);

struct StartChallenge {
  std::string path;
  COASTER_COMMAND(
      StartChallenge, "challenge",
      "Begin a challenge: opens its start track as an unsaved track. Forces are compared with the built-in limits.",
      Effect::session, {}, {PathUse::opens, RecordedForm::whole_path, true});
  COASTER_FIELDS(visit("", self.path))
};
struct LeaveChallenge {
  COASTER_COMMAND(LeaveChallenge, "challenge.leave", "Leave the challenge; the track stays as it is.",
                  Effect::settings);
  COASTER_FIELDS()
};
struct ShowHint {
  COASTER_COMMAND(ShowHint, "challenge.hint", "Show the challenge's next hint.", Effect::settings);
  COASTER_FIELDS()
};
struct CloseCard {
  COASTER_COMMAND(CloseCard, "card.close", "Close the score card of the last ride.", Effect::settings);
  COASTER_FIELDS()
};

COASTER_COMMAND_LIST(Challenge, StartChallenge, LeaveChallenge, ShowHint, CloseCard);

}  // namespace coaster::edit
