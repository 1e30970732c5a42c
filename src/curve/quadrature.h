// Nodes and weights of quadrature rules on [-1,1], computed once and kept: Gauss-Legendre (n nodes, exact to degree
// 2n-1) and Clenshaw-Curtis (n intervals, n+1 nodes, exact to degree n). Uses no libm function, so every machine has
// the same bits.
#pragma once

#include <span>

namespace coaster::curve {

constexpr int kMaxRule = 64;  // the largest n that is kept

// Ascending nodes in [-1,1], symmetric about 0, and their positive weights, which sum to 2. Right to 1 ulp.
struct Rule {
  std::span<const double> nodes, weights;
};
struct RuleLongDouble {
  std::span<const long double> nodes, weights;
};

// n in [1, kMaxRule] nodes.
Rule gauss_legendre_rule(int n);
RuleLongDouble gauss_legendre_rule_long_double(int n);

// n in [1, kMaxRule] intervals: the n + 1 nodes are cos(k pi / n), both ends included. doi 10.1007/BF01386223
Rule clenshaw_curtis_rule(int n);

// P_k(x) of Legendre, k >= 0, by the three-term recurrence.
long double legendre(int k, long double x);

}  // namespace coaster::curve
