#include "curve/quadrature.h"

#include <gtest/gtest.h>

#include <cmath>

namespace coaster::curve {
namespace quadrature_test {

// The integral of x^k over [-1,1] by the rule, minus the exact one.
long double monomial_error(std::span<const long double> nodes, std::span<const long double> weights, int k) {
  long double sum = 0;
  for (std::size_t i = 0; i < nodes.size(); ++i) sum += weights[i] * powl(nodes[i], static_cast<long double>(k));
  return sum - (k % 2 ? 0.0L : 2.0L / static_cast<long double>(k + 1));
}
double monomial_error(QuadratureRule rule, int k) {
  double sum = 0;
  for (std::size_t i = 0; i < rule.nodes.size(); ++i) sum += rule.weights[i] * std::pow(rule.nodes[i], k);
  return sum - (k % 2 ? 0.0 : 2.0 / (k + 1));
}

TEST(quadrature, gauss_legendre_is_exact_to_degree_two_n_minus_one_and_no_further) {
  for (int n = 1; n <= kMaxRule; ++n) {
    const RuleLongDouble rule = gauss_legendre_rule_long_double(n);
    ASSERT_EQ(rule.nodes.size(), static_cast<std::size_t>(n));
    for (int k = 0; k < 2 * n; ++k)
      ASSERT_NEAR(static_cast<double>(monomial_error(rule.nodes, rule.weights, k)), 0, 5e-18) << n << " nodes, x^" << k;
    if (n <= 16) {
      EXPECT_GT(std::abs(static_cast<double>(monomial_error(rule.nodes, rule.weights, 2 * n))), 1e-12) << n;
    }
  }
}

TEST(quadrature, clenshaw_curtis_is_exact_to_degree_n) {
  for (int n = 1; n <= kMaxRule; ++n) {
    const QuadratureRule rule = clenshaw_curtis_rule(n);
    ASSERT_EQ(rule.nodes.size(), static_cast<std::size_t>(n) + 1);
    EXPECT_EQ(rule.nodes.front(), -1);
    EXPECT_EQ(rule.nodes.back(), 1);
    for (int k = 0; k <= n; ++k) ASSERT_NEAR(monomial_error(rule, k), 0, 1e-14) << n << " intervals, x^" << k;
  }
}

TEST(quadrature, rules_are_ascending_symmetric_and_positive) {
  for (int n = 1; n <= kMaxRule; ++n)
    for (const QuadratureRule rule : {gauss_legendre_rule(n), clenshaw_curtis_rule(n)})
      for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
        EXPECT_GT(rule.weights[i], 0);
        EXPECT_EQ(rule.nodes[i], -rule.nodes[rule.nodes.size() - 1 - i]);
        EXPECT_EQ(rule.weights[i], rule.weights[rule.nodes.size() - 1 - i]);
        if (i > 0) {
          EXPECT_GT(rule.nodes[i], rule.nodes[i - 1]);
        }
      }
}

TEST(quadrature, known_rules_are_met) {
  // Two nodes at 1/sqrt 3; five with 128/225 in the middle; Clenshaw-Curtis with two intervals is Simpson's rule.
  EXPECT_DOUBLE_EQ(gauss_legendre_rule(2).nodes[1], 1 / std::sqrt(3.0));
  EXPECT_DOUBLE_EQ(gauss_legendre_rule(5).weights[2], 128.0 / 225);
  EXPECT_DOUBLE_EQ(gauss_legendre_rule(16).nodes[15], 0.989400934991649932596);
  EXPECT_DOUBLE_EQ(clenshaw_curtis_rule(2).weights[0], 1.0 / 3);
  EXPECT_DOUBLE_EQ(clenshaw_curtis_rule(2).weights[1], 4.0 / 3);
}

}  // namespace quadrature_test
}  // namespace coaster::curve
