// Commands of challenges and the score card. apply.cpp starts a challenge, because that opens a track.
#include "edit/perform/perform.h"

namespace coaster::edit {

using base::Status;

Status perform(Session& session, Change&, const LeaveChallenge&) {
  if (!session.game.challenge) return refused("there is no challenge to leave");
  session.game.challenge.reset();
  if (session.game.result) session.game.result->verdict.reset();
  return {};
}

Status perform(Session& session, Change&, const ShowHint&) {
  if (!session.game.challenge) return refused("there is no challenge");
  ActiveChallenge& challenge = *session.game.challenge;
  if (challenge.hints >= static_cast<int>(challenge.file.hints.size())) return refused("there is no further hint");
  ++challenge.hints;
  return {};
}

Status perform(Session& session, Change&, const CloseCard&) {
  session.game.show_result = false;
  return {};
}

}  // namespace coaster::edit
