// Keys of a force section from track that is there, and the values of keys for which it follows a given way to a given
// end: damped least squares.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "sim/plan/force_path.h"
#include "sim/plan/force_plan.h"
#include "sim/shape/derived_track.h"

namespace coaster::sim {

// The target of a program. Its keys keep their positions, and their slopes follow from the values (with_slopes below).
struct ForceGoal {
  std::function<ElementPoint(double s)> way;  // the point s m from the start
  ElementPoint end;                           // its end, matched to the accuracy of float knots
};

// Returns the task with values of its keys, except the first ones, that lead to the end and along the way, within
// millimetres if such values exist; nothing if no values lead to the end. Levenberg-Marquardt (Marquardt 1963, SIAM J.
// Appl. Math. 11:431) with differences; the program is over distance. `way_error` gets the largest distance from the
// way, m.
std::optional<ForceTask> solve_forces(const ForceTask& task, const ForceGoal& goal, double& way_error);

// Gives each key the slope of the parabola through it and its neighbours, and the first keys the values felt at the
// start.
void with_slopes(ForceTask& task);

// Returns the states along the program, at the positions of force_path(); fewer if the train is too slow.
struct ForceTrace {
  std::vector<double> at;
  std::vector<ForceState> states;
  ForceRates last;
  bool complete = false;
};
ForceTrace trace_force(const ForceTask& task);

// A run of segments whose shape is to be kept.
struct TrackRun {
  const DerivedTrack& derived;
  std::size_t first = 0, count = 0;  // segments
  double length() const { return derived.starts[first + count] - derived.starts[first]; }
  // Returns the point s m from its start. Spin is that of the roll against the rotation-minimising frame.
  ElementPoint at(double s) const;
};

inline constexpr double kKeptShape = 0.01;  // m

struct RunForcePlan {
  ForcePlan plan;       // plan of the keys; it ends where the run does, with its direction, curvature, roll and spin
  double error = 0;     // m, the largest distance of its spans from the run
  double error_at = 0;  // m from its start, position of that error
  std::string refusal;  // empty: the error is within kKeptShape
};

// Returns a program over distance whose plan keeps the run's shape, with few keys. `start` is the start of the run,
// with the train's speed there and the wanted tolerance (reduced if spans would leave the shape); its keys and length
// are not used. Takes about a second for 200 m.
RunForcePlan read_forces(const TrackRun& run, const ForceTask& start);

// Returns the largest distance of spans from the run, each measured at 16 points.
struct RunDeviation {
  double error = 0, at = 0;  // m, m from the spans' start
};
RunDeviation off_run(const TrackRun& run, const std::vector<world::Knot>& knots);

}  // namespace coaster::sim
