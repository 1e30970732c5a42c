// The candidates for a closing section: turns of several radii to both sides, with several heights between them,
// cheapest first. Clearance is not checked here.
#pragma once

#include "sim/plan/closing_curve.h"

namespace coaster::sim {

struct CircuitCandidate {
  std::size_t turns = 0;  // index into `CircuitCandidates::turns`
  int level = -1;         // index into `levels`; below 0: one constant slope
  bool tight = false;     // with bends of the smaller radii
  double cost = 0;        // m: cost_of(), or the distance from a former one
};
// m of length that is worth 1 g less: of vertical g, and of the lateral g of quick rolls.
inline constexpr double kCostOfG = 25, kCostOfSideG = 100;
// Returns the cost of a closing section, m.
inline double cost_of(double length, const FeltRange& felt) {
  return length + kCostOfG * felt.most + kCostOfSideG * felt.side;
}

// The reasons for which candidates were left out.
struct CircuitRejections {
  int steep = 0, buried = 0, slow = 0, forced = 0;
  double least_g = 1e9;  // smallest of the largest g of those left out for too much g
};

struct CircuitCandidates {
  CircuitTask task;
  CircuitLead in, out;
  std::vector<double> levels;  // m
  std::vector<TurnChoice> turns;
  std::vector<CircuitCandidate> list;  // by cost
  CircuitRejections losses;
  double arrival = 0;   // m/s at the first knot, approximately
  std::string refusal;  // why none is possible; empty: see `list`

  // Return the curve of a candidate: with turns that are accurate to about a centimetre, and exact.
  ClosingCurve rough(const CircuitCandidate& candidate) const;
  std::optional<ClosingCurve> exact(const CircuitCandidate& candidate) const;
  // Returns the description from which it can be planned again; `exact` is the candidate's curve.
  world::ClosingPlan described(const CircuitCandidate& candidate, const ClosingCurve& exact) const;
};

// Takes about 50 ms.
CircuitCandidates circuit_candidates(const CircuitTask& task);
// Returns the candidates similar to a former one, the most similar first. Takes about 2 ms.
CircuitCandidates candidates_like(const world::ClosingPlan& former, const CircuitTask& task);

}  // namespace coaster::sim
