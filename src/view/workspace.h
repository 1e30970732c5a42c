// What the view shows in each workspace.
#pragma once

#include "world/settings.h"

namespace coaster::view {

// True in Build, where a press selects sections and their handles show.
bool selects_sections(const world::Settings& settings);
// True if knots show that are neither selected nor under the cursor: not in Ride, and not with their layer off.
bool shows_knots(const world::Settings& settings);

}  // namespace coaster::view
