// The commands of the park: its land and the strokes of brushes. See command.h.
#pragma once

#include "edit/commands/command_fields.h"
#include "world/park.h"

namespace coaster::edit {
COASTER_COMMAND_GROUP(Park);

struct SetLand {
  world::Land to{};
  COASTER_COMMAND(SetLand, "park", "Set the land around the coaster, with its usual water and woods; plain: none.",
                  Effect::document, "Made the land {}");
  COASTER_FIELDS(visit("", self.to))
};

COASTER_COMMAND_LIST(Park, SetLand);

}  // namespace coaster::edit
