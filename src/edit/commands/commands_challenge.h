// The commands of challenges and the score card. See command.h.
#pragma once

#include <string>

#include "edit/commands/command_fields.h"

namespace coaster::edit {
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
