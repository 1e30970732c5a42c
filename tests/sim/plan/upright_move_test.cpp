#include "sim/plan/upright_move.h"

#include <gtest/gtest.h>

#include "world/sample_documents.h"

namespace coaster::sim {
namespace upright_move_test {

using glm::dvec3;

world::Knot knot(glm::vec3 position, glm::vec3 tangent, double roll_deg = 0) {
  world::Knot k = test::skew_knot(position, tangent, 3, 4);
  world::set_roll(k, roll_deg);
  return k;
}

TEST(carry, turns_about_the_vertical_alone) {
  const UprightMove carry = move_between({1, 2, 3}, {1, 5, 0}, {-7, 8, 9}, {0, -1, -2});
  EXPECT_EQ(carry.point({1, 2, 3}), dvec3(-7, 8, 9));
  // +X becomes -Z, so +Z becomes +X.
  EXPECT_LT(glm::distance(carry.point({4, 5, 4}), dvec3(-6, 11, 6)), 1e-12);
  EXPECT_LT(glm::distance(carry.direction({0.6, 0.8, 0}), dvec3(0, 0.8, -0.6)), 1e-15);
  const UprightMove shift = move_between({1, 2, 3}, {0, 1, 0}, {2, 2, 3}, {1, 0, 0});
  EXPECT_EQ(shift.direction({0.6, 0, 0.8}), dvec3(0.6, 0, 0.8)) << "a vertical direction has no heading";
}

TEST(carry, takes_one_knot_to_another_and_others_along) {
  const world::Knot from = knot({10.3f, 4.7f, -3.1f}, {0.8f, 0.3f, 0.4f}, 25),
                    to = knot({-50.1f, 9.3f, 7.7f}, {-0.4f, 0.3f, 0.8f}, 25);
  const auto carry = move_between(from, to);
  ASSERT_TRUE(carry) << carry.status().message;
  const world::Knot there = carry->knot(from);
  EXPECT_EQ(there.position, to.position);
  EXPECT_LT(glm::distance(there.tangent, to.tangent), 1e-6f);
  EXPECT_LT(glm::distance(there.up, to.up), 1e-6f);
  EXPECT_EQ(there.in_length, from.in_length);
  const world::Knot other = knot({20.7f, 14.1f, 3.3f}, {0.1f, 0.9f, 0.2f}, -70), carried = carry->knot(other);
  EXPECT_NEAR(world::roll_deg(carried), world::roll_deg(other), 1e-3);
  EXPECT_EQ(carried.tangent.y, other.tangent.y);
  EXPECT_NEAR(carried.position.y - there.position.y, other.position.y - from.position.y, 1e-5);
  EXPECT_NEAR(glm::distance(carried.position, there.position), glm::distance(other.position, from.position), 1e-5);
}

TEST(carry, never_tilts) {
  const world::Knot level = knot({0, 5, 0}, {1, 0, 0});
  const auto reason = [&](const world::Knot& to) {
    const auto carry = move_between(level, to);
    return carry ? "" : carry.status().message;
  };
  EXPECT_EQ(reason(knot({9, 9, 9}, {0, 0, -1})), "");
  EXPECT_EQ(reason(knot({9, 9, 9}, {1, 1, 0})),
            "the track would end pointing 45.0 degrees further up than what follows begins");
  EXPECT_EQ(reason(knot({9, 9, 9}, {1, -1, 0})),
            "the track would end pointing 45.0 degrees further down than what follows begins");
  EXPECT_EQ(reason(knot({9, 9, 9}, {0, 0, 1}, 30)),
            "the track would end there rolled by 30.0 degrees against what follows");
  EXPECT_EQ(reason(knot({9, 9, 9}, {1, 0.0005f, 0})),
            "the track would end pointing 0.03 degrees further up than what follows begins")
      << "never 0.0 degrees";
  EXPECT_EQ(reason(knot({9, 9, 9}, {1, 0, 0}, 0.02)),
            "the track would end there rolled by 0.02 degrees against what follows");
}

}  // namespace upright_move_test
}  // namespace coaster::sim
