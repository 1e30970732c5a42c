// Banking from the ride: the knots' up vectors for which the felt force points straight into the seat.
#pragma once

#include <vector>

#include "sim/ride/simulated_ride.h"

namespace coaster::sim {

// Returns the `up` of every knot of the track, in order, that cancels the lateral g there at the speed with which the
// middle car of the simulated ride first passes. It is the felt direction (the rails' curvature at that speed, less
// gravity), perpendicular to the tangent and within 90 degrees of the present up, so that airtime does not turn riders
// over. A knot keeps its up if the simulated ride does not reach it or less than kLeastFelt g is felt across the track.
// At a joint where the curvature jumps, the mean of both sides counts.
inline constexpr double kLeastFelt = 0.05;  // g
std::vector<glm::vec3> banked_ups(const world::Document& document, const DerivedTrack& derived,
                                  const SimulatedRide& simulated);
// Turns the knots to them; returns the number of knots that turned.
int bank_knots(world::Document& document, const DerivedTrack& derived, const SimulatedRide& simulated);

}  // namespace coaster::sim
