// Nodes and weights of quadrature rules on [-1,1], computed once and cached: Gauss-Legendre (n nodes, exact to degree
// 2n-1) and Clenshaw-Curtis (n intervals, n+1 nodes, exact to degree n). Uses no libm function, so every machine has
// the same bits.
#pragma once

#include <span>

namespace coaster::curve {

constexpr int kMaxRule = 64;  // the largest cached n

// Ascending nodes in [-1,1], symmetric about 0, and their positive weights, which sum to 2. Accurate to 1 ulp.
struct QuadratureRule {
  std::span<const double> nodes, weights;
};
struct RuleLongDouble {
  std::span<const long double> nodes, weights;
};

// Returns the rule of n nodes, n in [1, kMaxRule].
QuadratureRule gauss_legendre_rule(int n);
RuleLongDouble gauss_legendre_rule_long_double(int n);

// Returns the rule of n intervals, n in [1, kMaxRule]: the n + 1 nodes are cos(k pi / n), both ends included. doi
// 10.1007/BF01386223
QuadratureRule clenshaw_curtis_rule(int n);

// Returns the Legendre polynomial P_k(x), k >= 0, by the three-term recurrence.
long double legendre(int k, long double x);

}  // namespace coaster::curve
