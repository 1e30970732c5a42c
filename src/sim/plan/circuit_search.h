// The candidates of a way home: turns of several radii to both sides, with several heights between them, cheapest
// first. Whether they have room is not looked at here.
#pragma once

#include "sim/plan/circuit_way.h"

namespace coaster::sim {

struct CircuitCandidate {
  std::size_t turns = 0;  // index into `CircuitCandidates::turns`
  int level = -1;         // index into `levels`; below 0: one slope all the way
  bool tight = false;     // with bends of the smaller radii
  double cost = 0;        // m: cost_of(), or how far it is from a former way
};
// m of length that a rider would go round for 1 g less: vertical, and lateral, which quick rolls cause.
inline constexpr double kCostOfG = 25, kCostOfSideG = 100;
// Returns the cost of a way home, m.
inline double cost_of(double length, const FeltRange& felt) {
  return length + kCostOfG * felt.most + kCostOfSideG * felt.side;
}

// Why candidates were left out.
struct CircuitLosses {
  int steep = 0, buried = 0, slow = 0, forced = 0;
  double least_g = 1e9;  // the least of the largest felt g among those left out for it
};

struct CircuitCandidates {
  CircuitTask task;
  Lead in, out;
  std::vector<double> levels;  // m
  std::vector<TurnChoice> turns;
  std::vector<CircuitCandidate> list;  // by cost
  CircuitLosses losses;
  double arrival = 0;   // m/s at the first knot, about
  std::string refusal;  // why there can be no way at all; empty: see `list`

  // Return the way of a candidate: with turns that are wrong by about a centimetre, and exact.
  CircuitWay rough(const CircuitCandidate& candidate) const;
  std::optional<CircuitWay> exact(const CircuitCandidate& candidate) const;
  // Returns what it is planned again from; `exact` is its way.
  world::WayHome described(const CircuitCandidate& candidate, const CircuitWay& exact) const;
};

// Takes about 50 ms.
CircuitCandidates circuit_candidates(const CircuitTask& task);
// Returns those that are like a former way, the most similar first. Takes about 2 ms.
CircuitCandidates candidates_like(const world::WayHome& former, const CircuitTask& task);

}  // namespace coaster::sim
