// The ideal path of a force section: the track on which riders feel what its program requires, or that bends as it
// requires, by integration. Formulas
// and sources: docs/forces.md.
#pragma once

#include <string>
#include <vector>

#include "sim/plan/force_law.h"

namespace coaster::sim {

// A point of the path; arc length, position and frame are those of the curve's point with the same index.
struct ForcePoint {
  double at = 0;                  // m or s: what the keys count in
  double time = 0;                // s since the section's start
  double square = 0;              // m^2/s^2, the speed squared
  double along = 0;               // m/s^2 along the track
  double up = 1, side = 0;        // g that riders feel on it
  std::array<double, 3> keys{};   // by channel: what the keys ask for, as ramped from what the track's end has
  std::array<double, 3> added{};  // by channel: what is added to that so that the section ends as held
  double asked(world::ForceChannel channel) const { return keys[static_cast<std::size_t>(channel)]; }
};

struct ForcePath {
  ElementCurve curve;
  std::vector<ForcePoint> points;
  double ramp = 0;      // m or s, over which the start reaches the values of the keys; 0 if it has them already
  std::string stopped;  // why the path ends before its program does: "the train falls below 3 m/s"; else empty
};

// A turn tighter than this folds rails and cars.
inline constexpr double kTightestForce = 2;  // m, radius
// A path closer than this to its earlier rails collides with itself.
inline constexpr double kOwnRails = 1;  // m

// Integrates by Runge-Kutta 4 in steps of at most 0.25 m that end at each key: position, direction, up, speed, length
// and time. Positions are accurate to a millimetre after 300 m. The same bits everywhere. Takes about a microsecond a
// step.
ForcePath force_path(const ForceTask& task);

}  // namespace coaster::sim
