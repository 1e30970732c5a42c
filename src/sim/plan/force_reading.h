// Converts existing track to a force section: reads its g and roll, reduces them to few keys, and solves for values of
// the keys that keep the shape and the end.
#pragma once

#include <vector>

#include "sim/plan/force_plan.h"
#include "sim/shape/derived.h"

namespace coaster::sim {

// A run of segments whose shape is to be kept.
struct TrackRun {
  const Derived& derived;
  std::size_t first = 0, count = 0;  // segments
  double length() const { return derived.starts[first + count] - derived.starts[first]; }
  // Returns the point s m from its start. Spin is that of the roll against the rotation-minimising frame.
  ElementPoint at(double s) const;
};

inline constexpr double kKeptShape = 0.01;  // m

struct ForceReading {
  ForcePlan plan;       // plan of the keys; it ends where the run does, with its direction, curvature, roll and spin
  double error = 0;     // m, the largest distance of its spans from the run
  double error_at = 0;  // m from its start, position of that error
  std::string refusal;  // empty: the error is within kKeptShape
};

// Returns a program over distance whose plan keeps the run's shape, with few keys. `start` is the start of the run,
// with the train's speed there and the wanted tolerance (reduced if spans would leave the shape); its keys and length
// are not used. Takes about a second for 200 m.
ForceReading read_forces(const TrackRun& run, const ForceTask& start);

// Returns the largest distance of spans from the run, each measured at 16 points.
struct OffRun {
  double error = 0, at = 0;  // m, m from the spans' start
};
OffRun off_run(const TrackRun& run, const std::vector<world::Knot>& knots);

}  // namespace coaster::sim
