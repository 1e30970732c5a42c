// The values of a force section's keys for which it follows a given way to a given end: damped least squares.
#pragma once

#include <functional>
#include <optional>

#include "sim/plan/force_law.h"

namespace coaster::sim {

// What a program is to keep. Its keys' places stay, and their slopes follow from the values (with_slopes below).
struct ForceGoal {
  std::function<ElementPoint(double s)> way;  // the place s m from the start
  ElementPoint end;                           // where it ends, held as exactly as float knots tell
};

// Returns the task with values of its keys, but for the first ones, that lead along the way within millimetres, if
// there are such, and to the end; nothing where it does not get there. Levenberg-Marquardt (Marquardt 1963, SIAM J.
// Appl. Math. 11:431) with differences; the program is over distance. `way_error` gets the largest distance from the
// way, m.
std::optional<ForceTask> solve_forces(const ForceTask& task, const ForceGoal& goal, double& way_error);

// Gives each key the slope of the parabola through it and its neighbours, and the first keys what is felt at the start.
void with_slopes(ForceTask& task);

// Returns the states along the program, at the places of force_path(); fewer where the train is too slow.
struct ForceTrace {
  std::vector<double> at;
  std::vector<ForceState> states;
  ForceRates last;
  bool complete = false;
};
ForceTrace trace_force(const ForceTask& task);

}  // namespace coaster::sim
