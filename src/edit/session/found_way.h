// A way home that was found in advance, for a command that is applied again.
#pragma once

#include "sim/study/way_change.h"

namespace coaster::edit {

struct FoundWay {
  sim::WayChange change;
  sim::ChangedWay way;
};

}  // namespace coaster::edit
