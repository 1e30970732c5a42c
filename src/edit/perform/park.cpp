// Commands of the park.
#include "edit/commands/commands_park.h"
#include "edit/perform/perform_context.h"

namespace coaster::edit {

using base::Status;

Status perform(Session& session, Change&, const SetLand& command) {
  session.document.park = world::usual_park(command.to, session.document.park.seed);
  return {};
}

}  // namespace coaster::edit
