// Commands on the document's own members: name, start speed, datum.
#include <cmath>

#include "base/utf8.h"
#include "edit/perform/perform.h"

namespace coaster::edit {
namespace {

using base::Status;

}  // namespace

Status perform(Session& session, Change&, const SetName& command) {
  if (command.to.size() > world::kMaxNameBytes)
    return refused("the name is over the limit of " + std::to_string(world::kMaxNameBytes) + " bytes");
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
