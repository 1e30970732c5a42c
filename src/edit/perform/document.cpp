// Commands on the document's own members: name, start speed, datum.
#include <cmath>

#include <fmt/format.h>

#include "base/utf8.h"
#include "edit/commands/commands_document.h"
#include "edit/perform/perform.h"

namespace coaster::edit {

using base::Status;

Status perform(Session& session, Change&, const SetName& command) {
  if (command.to.size() > world::kMaxNameBytes)
    return refused(fmt::format("the name is over the limit of {} bytes", world::kMaxNameBytes));
  if (!base::is_printable_utf8(command.to)) return refused("expected a name in UTF-8 without control characters");
  session.document.name = command.to;
  return {};
}

Status perform(Session& session, Change& change, const SetStartSpeed& command) {
  if (!std::isfinite(command.to)) return refused("expected a finite speed");
  session.document.start_speed = change.clamp("start speed", command.to, -world::kMaxSpeed, world::kMaxSpeed, "m/s");
  return {};
}

Status perform(Session& session, Change& change, const SetDatum& command) {
  if (!std::isfinite(command.to)) return refused("expected a finite height");
  session.document.datum =
      change.clamp("datum", command.to, -double{world::kMaxCoordinate}, double{world::kMaxCoordinate}, "m");
  return {};
}

}  // namespace coaster::edit
