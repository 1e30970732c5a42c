// The oracle itself, against closed forms.
#include "curve/length_oracle.h"

#include <gtest/gtest.h>

#include "curve/random_cubics.h"

namespace coaster::curve {
namespace length_oracle_test {

TEST(length_oracle, closed_forms_are_met) {
  const Cubic cusp{{0, 0, 0}, {1, 1, 0}, {0, 1, 0}, {1, 0, 0}};  // 2 sqrt 2 - 1
  EXPECT_NEAR(static_cast<double>(LengthOracle(cusp).length()), 2 * std::sqrt(2.0) - 1, 3e-16);
  const Cubic back{
      {0, 0, 0}, {3, 0, 0}, {-3, 0, 0}, {0, 0, 0}};  // x = 9 t (1-t) (1-2t): twice out and back to sqrt(3)/2
  EXPECT_NEAR(static_cast<double>(LengthOracle(back).length()), 2 * std::sqrt(3.0), 1e-15);
  const Cubic line{{1, 2, 3}, {1.5f, 2, 3}, {6, 2, 3}, {8, 2, 3}};
  EXPECT_NEAR(static_cast<double>(LengthOracle(line).length()), 7, 1e-15);
}

TEST(length_oracle, parts_add_up_on_every_kind_of_cubic) {
  // The parts put the rule's nodes elsewhere, so that a node rule at fault would show.
  for (const CubicSet& set : cubic_sets(100, 61))
    for (const Cubic& c : set.cubics) {
      const LengthOracle oracle(c);
      const long double whole = oracle.length(),
                        parts = oracle.length(0, 0.271L) + oracle.length(0.271L, 0.618L) + oracle.length(0.618L, 1);
      EXPECT_LT(fabsl(whole - parts), 1e-15L * whole) << set.name;
    }
}

}  // namespace length_oracle_test
}  // namespace coaster::curve
