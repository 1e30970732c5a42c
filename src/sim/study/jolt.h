// Jolts: the effect on riders of the jumps of curvature and roll at a joint. Felt g is continuous where the track is,
// so a jolt is the difference that the joint makes.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "sim/ride/simulated_ride.h"

namespace coaster::sim {

inline constexpr double kJoltLimit = 1.0;   // g: joints above are marked
inline constexpr double kStepLimit = 0.05;  // g: steps above are shown in red

// The largest difference of felt g with and without a joint's jumps, after the forces' low-pass: of each axis, and the
// largest length of all three together. Of several passages each takes the largest.
struct Jolt {
  double forward = 0, left = 0, up = 0;  // g, absolute
  double total = 0;                      // g
  int car = 0;                           // car with the largest total
  double speed = 0;                      // m/s, of that car there; negative: backwards
  double fastest = 0;                    // m/s, the largest speed of all cars there, either way; 0: no passage
};

// Returns the jolt of one passage: cutoff (Hz) impulse r'(cutoff t) + step r(cutoff t), r being the response of the
// low-pass of 1 Hz to a unit step. Within 0.1 % of the continuous filter.
Jolt jolt_of(const JointPassage& passage, double cutoff);

// Returns the jolts of the simulated ride's passages of joints, in their order. Where a joint that the car passes at
// most 1 / (2 cutoff) before or after steps the other way, as where a roll begins within half a metre, consecutive
// joints count together if that is less: their steps and impulses, and how felt g changes between them.
std::vector<Jolt> passage_jolts(const SimulatedRide& simulated, double cutoff);

// Returns the jolts of the knots, by index in the track, up to the last knot that the ride passes. 0 at knots that it
// does not pass, as at the first knot of an open track.
std::vector<Jolt> jolts(const SimulatedRide& simulated, double cutoff);

// Returns the step of the force, g, that the jump of curvature at a knot makes at the fastest passage: v^2 |dK| / g.
// `knot`: its index in the track. Nothing where the ride does not pass.
std::optional<double> fastest_step(const world::Document& document, std::span<const Jolt> jolts, std::size_t knot);
// Returns the largest one of the track; nothing where the ride passes no joint.
std::optional<double> largest_step(const world::Document& document, std::span<const Jolt> jolts);

}  // namespace coaster::sim
