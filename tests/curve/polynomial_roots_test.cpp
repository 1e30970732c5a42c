#include "curve/polynomial_roots.h"

#include <algorithm>
#include <random>

#include <gtest/gtest.h>

namespace coaster::curve {
namespace polynomial_roots_test {

double uniform(std::mt19937& bits, double low, double high) { return low + (high - low) * (bits() / 4294967296.0); }

// Polynomials that are products of (t - root): the roots of odd order come back in order, and which way the sign goes.
TEST(polynomial_roots, those_of_a_product_are_found_between_zero_and_one) {
  std::mt19937 bits(4);
  for (int trial = 0; trial < 2000; ++trial) {
    std::vector<double> roots;
    for (int i = 0; i < 8; ++i) roots.push_back(uniform(bits, -0.5, 1.5));
    if (trial % 4 == 0) roots[3] = 0.5, roots[4] = 0.25;  // on the middle of halves
    // In Bernstein form by blossoms: coefficient k is the mean over all ways to give k of the eight factors t = 1, the
    // others t = 0.
    std::array<double, 9> c{};
    std::array<double, 9> ways{};
    for (unsigned set = 0; set < 256; ++set) {
      double product = 1;
      for (std::size_t i = 0; i < 8; ++i) product *= (set >> i & 1 ? 1 : 0) - roots[i];
      c[static_cast<std::size_t>(std::popcount(set))] += product, ++ways[static_cast<std::size_t>(std::popcount(set))];
    }
    for (std::size_t k = 0; k < 9; ++k) c[k] /= ways[k];
    std::vector<double> wanted;
    for (const double r : roots)
      if (r > 0 && r < 1) wanted.push_back(r);
    std::sort(wanted.begin(), wanted.end());
    bool too_close = false;
    for (std::size_t i = 1; i < wanted.size(); ++i) too_close = too_close || wanted[i] - wanted[i - 1] < 1e-3;
    for (const double r : wanted) too_close = too_close || r < 1e-6 || r > 1 - 1e-6;
    if (too_close) continue;
    std::vector<double> found;
    each_root(c, [&](double t) { found.push_back(t); });
    ASSERT_EQ(found.size(), wanted.size()) << trial;
    for (std::size_t i = 0; i < found.size(); ++i) EXPECT_NEAR(found[i], wanted[i], 1e-7) << trial;
    // At first the sign is that of (-1)^roots below: every second crossing rises.
    std::vector<Bracket> rises;
    each_rise(c, [&](const Bracket& b) { rises.push_back(b); });
    const bool falls_first = c.front() >= 0;
    ASSERT_EQ(rises.size(), (wanted.size() + (falls_first ? 0 : 1)) / 2) << trial;
    for (std::size_t i = 0; i < rises.size(); ++i) {
      const double root = wanted[2 * i + (falls_first ? 1 : 0)];
      EXPECT_TRUE(rises[i].low <= root + 1e-12 && root <= rises[i].high + 1e-12) << trial;
    }
  }
}

TEST(polynomial_roots, a_scalar_product_has_the_values_of_its_factors) {
  std::mt19937 bits(6);
  const auto point = [&] { return glm::dvec3{uniform(bits, -9, 9), uniform(bits, -9, 9), uniform(bits, -9, 9)}; };
  for (int trial = 0; trial < 200; ++trial) {
    const std::array<glm::dvec3, 4> a{point(), point(), point(), point()};
    const std::array<glm::dvec3, 3> b{point(), point(), point()};
    const std::array<double, 6> both = product(a, b);
    const double t = uniform(bits, 0, 1), s = 1 - t;
    const glm::dvec3 x = s * s * s * a[0] + 3 * s * s * t * a[1] + 3 * s * t * t * a[2] + t * t * t * a[3];
    const glm::dvec3 y = s * s * b[0] + 2 * s * t * b[1] + t * t * b[2];
    std::array<double, 6> row = both;
    EXPECT_NEAR((de_casteljau_in_place<double, double>(row, t)), glm::dot(x, y), 1e-10);
  }
}

}  // namespace polynomial_roots_test
}  // namespace coaster::curve
