// Commands of challenges and the score card.
#include "edit/commands/commands_challenge.h"
#include "edit/perform/perform.h"
#include "exchange/challenge_file.h"

namespace coaster::edit {

using base::Status;

// The referee must be able to parse its rules.
Status perform(Session& session, Change& change, const StartChallenge& command) {
  base::Result<exchange::LoadedChallenge> loaded = exchange::load_challenge(change.files, command.path);
  if (!loaded) return loaded.status();
  if (session.game.referee.check)
    if (const Status readable = session.game.referee.check(loaded->challenge, command.path); !readable) return readable;
  start_over(session, loaded->challenge.start, {});
  session.limits.envelope = sim::default_envelope(), session.limits.name = "default";
  ++session.limits.serial;
  session.game.challenge.emplace();
  session.game.challenge->shape = sim::trace_of(session.document);
  session.game.challenge->file = std::move(loaded->challenge);
  session.game.challenge->path = command.path;
  warn(session, loaded->warnings);
  return {};
}

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
