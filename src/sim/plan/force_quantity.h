// What the keys of a force section count: metres or seconds, forces or curvature, and the change from one to the other.
#pragma once

#include <array>

#include "sim/plan/force_plan.h"
#include "sim/shape/derived.h"

namespace coaster::sim {

// Returns the program with its keys, length and handles on the other axis: they stay at the same positions of the plan.
world::ForceProgram over_other_axis(const ForcePlan& plan);

// Returns a program of curvature for one of forces, and the other way round, that leads along about the same path: keys
// stay at their positions, with what the path has there, and there are more at both ends and where the curves between
// them would be off by more than 0.005 g (of curvature at world::kCurvatureSpeed), 0.01 degrees of roll per metre or an
// angle of 0.1 degrees. The plan reaches its end.
world::ForceProgram of_other_quantity(const ForcePlan& plan);

// Returns by channel, in the units of keys of curvature, what the track has at a distance (m) from its start, which
// lies on the segment with index `first` or behind it: roll counts from that segment's start.
std::array<double, 3> curvature_at(const Derived& derived, std::size_t first, double distance);

}  // namespace coaster::sim
