// The poses of all cars for a picture. Of very many, those that nobody sees from near are approximate.
#pragma once

#include <cstddef>
#include <vector>

#include "sim/ride/ride.h"

namespace coaster::sim {

// Returns the poses of the cars of all trains, each as car_poses() does. Beyond the `exact` cars nearest to the eye and
// by the frame method `knots`, they are approximate, at a tenth of the cost: at most max |B''| / 8192 m from their
// place on the curve B, and turned by less than a 32nd of the segment's turn.
std::vector<Pose> shown_cars(const world::Document& document, const Derived& derived, const world::Motion& motion,
                             world::FrameMethod method, glm::dvec3 eye, std::size_t exact);

}  // namespace coaster::sim
