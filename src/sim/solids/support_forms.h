// The forms of a support, in the order in which they are tried. Private to this room.
#pragma once

#include <functional>
#include <span>

#include "sim/solids/clearance.h"

namespace coaster::sim {

// Calls `takes` with the bars of one form after the other for the track at `at`, until it returns true; returns false
// if it never does. The forms: a vertical column; two legs for high track or if the vertical is blocked; a leaning leg;
// a column next to the track with an arm, used for inverted track. Bars start in the spine or at an elbow and stay
// within kSupportReach of it sideways.
bool try_forms(const Ring& at, const std::function<bool(std::span<const Bar>)>& takes);

}  // namespace coaster::sim
