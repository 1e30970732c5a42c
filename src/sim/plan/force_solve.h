// Solves for the values of a force section's keys for which it follows a given way to a given end: damped least
// squares.
#pragma once

#include <functional>
#include <optional>

#include "sim/plan/force_law.h"

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

}  // namespace coaster::sim
