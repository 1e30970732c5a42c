// The forms that a support can have, in the order in which they are tried. Private to this room.
#pragma once

#include <functional>
#include <span>

#include "sim/solids/clearance.h"

namespace coaster::sim {

// Calls `takes` with the bars of form after form for the track at `at`, until it returns true; false when it never
// does. Straight down; two legs where the track is high or straight down is taken; a leaning leg; a column beside the
// track with an arm, which is what track on its head gets. Bars start in the spine or at an elbow and stay within
// kSupportReach of it, sideways.
bool try_forms(const Ring& at, const std::function<bool(std::span<const Bar>)>& takes);

}  // namespace coaster::sim
