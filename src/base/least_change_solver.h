// Solves one equation in several unknowns with the least change of the unknowns.
#pragma once

#include <functional>
#include <optional>
#include <vector>

namespace coaster::base {

// One unknown.
struct Unknown {
  double start = 0;
  double step = 1;           // > 0: a small change that affects the value, and the unit of the unknown's change
  double low = 0, high = 0;  // low <= start <= high
};

struct Equation {
  // Returns the value at these unknowns; nothing if there is none. Need not be smooth.
  std::function<std::optional<double>(const std::vector<double>&)> value;
  std::vector<Unknown> unknowns;
  double wanted = 0, tolerance = 0;  // > 0
  int trials = 400;                  // maximum number of evaluations
  std::function<bool(double done)> goes_on =
      {};  // called before each evaluation with the part of `trials` used; may be empty
};

enum class SolutionEnd { met, no_value, no_effect, stuck, trials_used, cancelled };
struct Solution {
  SolutionEnd end = SolutionEnd::stuck;
  std::vector<double> unknowns;  // the best found, within their limits
  double value = 0;              // at the unknowns; 0 if end is no_value: no value at the start
  int trials = 0;
};

// Follows the direction of least change, the gradient in units of the steps, to the wanted value; secants and bisection
// find it there (Illinois rule; Dowell and Jarratt 1971, BIT 11:168). The gradient, by differences of one step, is
// computed again if the search along it ends too early. With one unknown this is a bracketed secant search. For a
// linear function and limits that are not reached, the change has the least Euclidean length in units of the steps.
Solution solve_by_least_change(const Equation& equation);

}  // namespace coaster::base
