// How the end of a force section changes with what is added to what its keys ask for: for force_end_constraint.h, by
// one integration there and one back instead of one for each unknown.
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <vector>

#include "sim/plan/force_path.h"

namespace coaster::sim {

// What an end misses of its nine conditions.
using EndMiss = std::array<double, 9>;
using MissAt = std::function<std::optional<EndMiss>(const ForceRates&, const ForceState&)>;

// Returns the derivatives of the misses at the end of the law's path by the value of each node of what is added,
// channel by channel: `nodes` of them at equal distances behind the start, whose own stays 0, with slopes of parabolas,
// level at both ends. Solves the adjoint equations of the linearised law by Runge-Kutta 4 in steps of about 2 m;
// relative error below 1e-3 in bends of 8 m radius and wider. Nothing where the path or its misses end early. The same
// bits everywhere.
std::optional<std::vector<EndMiss>> end_slopes(const ForceLaw& law, double length, std::size_t nodes,
                                               const MissAt& miss);

}  // namespace coaster::sim
