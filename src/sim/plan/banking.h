// Banking by the ride: the knots' up at which riders are pressed straight into their seats.
#pragma once

#include <vector>

#include "sim/ride/ghost.h"

namespace coaster::sim {

// The `up` for every knot of the track, in order, that cancels the lateral g there at the speed with which the middle
// car of the ghost passes first: along what is felt (the rails' curvature at that speed, less gravity), square to the
// tangent, and within 90 degrees of the present up, so that airtime does not turn riders over. A knot that the ghost
// does not reach, or where less than kLeastFelt g is felt across the track, keeps its up. At a joint where the
// curvature jumps, the mean of both sides counts.
inline constexpr double kLeastFelt = 0.05;  // g
std::vector<glm::vec3> banked_ups(const world::Document& document, const Derived& derived, const Ghost& ghost);

}  // namespace coaster::sim
