#include "curve/bernstein.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "curve/random_cubics.h"

namespace coaster::curve {
namespace bernstein_test {

using glm::dvec3;

std::vector<dvec3> random_controls(int degree, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> place(-91.7, 113.3);
  std::vector<dvec3> all;
  for (int i = 0; i <= degree; ++i) all.push_back(dvec3{place(random), place(random), place(random)});
  return all;
}

RC_GTEST_PROP(bernstein, basis_is_a_partition_of_unity_and_symmetric, ()) {
  const int n = *rc::gen::inRange(0, 40);
  const double t = *rc::gen::inRange(0, 100'001) / 100'000.0;
  std::vector<long double> weights(static_cast<std::size_t>(n) + 1), mirrored(weights.size());
  bernstein_basis<long double>(t, weights);
  bernstein_basis<long double>(1.0L - static_cast<long double>(t), mirrored);
  long double sum = 0;
  for (std::size_t i = 0; i < weights.size(); ++i) {
    RC_ASSERT(weights[i] >= 0 && weights[i] <= 1);
    RC_ASSERT(fabsl(weights[i] - mirrored[weights.size() - 1 - i]) < 1e-17L);
    sum += weights[i];
  }
  RC_ASSERT(fabsl(sum - 1) < 1e-17L);
}

TEST(bernstein, basis_is_the_binomial_formula) {
  for (int n = 0; n <= 12; ++n)
    for (const double t : {0.0, 0.137, 0.5, 0.913, 1.0}) {
      std::vector<double> weights(static_cast<std::size_t>(n) + 1);
      bernstein_basis<double>(t, weights);
      for (int i = 0; i <= n; ++i) {
        const double binomial = std::round(std::tgamma(n + 1.0) / (std::tgamma(i + 1.0) * std::tgamma(n - i + 1.0)));
        EXPECT_NEAR(weights[static_cast<std::size_t>(i)], binomial * std::pow(t, i) * std::pow(1 - t, n - i), 1e-14)
            << i << " of " << n << " at " << t;
      }
    }
}

TEST(bernstein, weights_and_construction_give_the_same_point_for_every_degree) {
  for (int degree = 0; degree <= 20; ++degree) {
    const std::vector<dvec3> controls = random_controls(degree, 40 + static_cast<unsigned>(degree));
    for (const double t : {0.0, 0.0713, 0.49, 0.871, 1.0}) {
      std::vector<double> weights(controls.size());
      bernstein_basis<double>(t, weights);
      dvec3 sum(0);
      for (std::size_t i = 0; i < controls.size(); ++i) sum += weights[i] * controls[i];
      std::vector<dvec3> row = controls;
      const dvec3 point = de_casteljau_in_place<double, dvec3>(row, t);
      EXPECT_LT(glm::length(sum - point), 1e-12);  // 20 sums of coordinates near 100
      EXPECT_EQ((de_casteljau_levels<double, dvec3>(controls, t).back()), point);
      EXPECT_TRUE(t != 0.0 || point == controls.front());
      EXPECT_TRUE(t != 1.0 || point == controls.back());
    }
  }
}

TEST(bernstein, construction_agrees_with_the_cubic_and_its_split) {
  for (const Cubic& c : random_cubics(30, 42)) {
    for (const double t : {0.0, 0.123, 0.5, 0.871, 1.0}) {
      const DeCasteljauPoints k = construction(c, t);
      EXPECT_LT(glm::length(k.point - point(c, t)), 1e-12);
      EXPECT_LT(glm::length(k.point - point_long_double(c, t)), 1e-13);
      const SplitCubic halves = split(c, t);
      EXPECT_EQ(glm::vec3(k.first[0]), halves.left.p1);
      EXPECT_EQ(glm::vec3(k.second[0]), halves.left.p2);
      EXPECT_EQ(glm::vec3(k.second[1]), halves.right.p1);
      EXPECT_EQ(glm::vec3(k.first[2]), halves.right.p2);
      // The last line is the tangent: B' = 3 (second[1] - second[0]).
      EXPECT_LT(glm::length(3.0 * (k.second[1] - k.second[0]) - derivative(c, t)), 1e-11);
    }
  }
}

}  // namespace bernstein_test
}  // namespace coaster::curve
