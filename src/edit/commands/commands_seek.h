// The command that searches for numbers that reach a goal. See command.h.
#pragma once

#include "edit/commands/command_fields.h"
#include "world/document.h"

namespace coaster::edit {
COASTER_COMMAND_GROUP(Seek);

// `by` is height, x, z, place or roll of knots, or a parameter of sections. Of force sections it is length, a channel
// for all of its keys, or "vertical at 40" for one key. The limits apply to each of these numbers: m, or degrees for
// roll, or the unit of the parameter or key.
struct SeekGoal {
  Phrase goal, by;
  KnotsOrSections of;
  Knots except;
  double above = -world::kMaxCoordinate, below = world::kMaxCoordinate;
  bool together = false;
  COASTER_COMMAND(SeekGoal, "seek",
                  "Change numbers as little as possible until a query has a value: seek ride.lap_time == 40 by height "
                  "of @k3..@k9. By height, x, z, place or roll of knots, or by a parameter of sections. Knots of "
                  "except stay; above and below are limits; with together on, all change by the same amount. Of force "
                  "sections by length, by the keys of a channel, or by one key: by vertical at 40.",
                  Effect::document, "Changed {by} of {of} for {}");
  COASTER_FIELDS(visit("", self.goal), visit("by", self.by), visit("of", self.of), visit("except?", self.except),
                 visit("above?", self.above), visit("below?", self.below), visit("together?", self.together))
};

COASTER_COMMAND_LIST(Seek, SeekGoal);

}  // namespace coaster::edit
