#include "curve/continuity.h"

#include <gtest/gtest.h>

#include "base/enum_names.h"
#include "curve/random_cubics.h"

namespace coaster::curve {
namespace continuity_test {

const Cubic kBefore{{1, 2, 3}, {4, 3, 3}, {7, 5, 2}, {11, 6, 2}};  // B'(1) = 3 (4, 1, 0)

TEST(continuity, the_two_halves_of_a_split_are_c2_in_their_own_scale_and_g2) {
  for (const Cubic& c : random_cubics(50, 41)) {
    const SplitCubic s = split(c, 0.5);
    const JointContinuity j = joint(s.left, s.right);
    EXPECT_EQ(j.geometric, GeometricContinuity::g2);
    EXPECT_NEAR(j.speed_ratio, 1, 1e-4);
  }
}

TEST(continuity, an_uneven_split_is_g2_but_not_c1) {
  // Paper erratum: the split scales the parametric speed.
  const SplitCubic s = split(kBefore, 0.25);
  const JointContinuity j = joint(s.left, s.right);
  EXPECT_EQ(j.geometric, GeometricContinuity::g2);
  EXPECT_EQ(j.parametric, ParametricContinuity::c0);
  EXPECT_NEAR(j.speed_ratio, 3, 1e-4);
}

TEST(continuity, classes_are_told_apart) {
  const Cubic gap{{11.5f, 6, 2}, {15, 7, 2}, {18, 9, 3}, {20, 9, 3}};
  EXPECT_EQ(joint(kBefore, gap).geometric, GeometricContinuity::broken);
  EXPECT_NEAR(joint(kBefore, gap).gap, 0.5, 1e-6);
  const Cubic corner{{11, 6, 2}, {11, 9, 2}, {14, 9, 3}, {20, 9, 3}};
  EXPECT_EQ(joint(kBefore, corner).geometric, GeometricContinuity::g0);
  const Cubic g1{{11, 6, 2}, {13, 6.5f, 2}, {14, 9, 3}, {20, 9, 3}};
  EXPECT_EQ(joint(kBefore, g1).geometric, GeometricContinuity::g1);
  EXPECT_EQ(joint(kBefore, g1).parametric, ParametricContinuity::c0);
  const Cubic c1{{11, 6, 2}, {15, 7, 2}, {14, 9, 3}, {20, 9, 3}};
  EXPECT_EQ(joint(kBefore, c1).geometric, GeometricContinuity::g1);
  EXPECT_EQ(joint(kBefore, c1).parametric, ParametricContinuity::c1);
  // Equal second derivatives: c2 = b1 + 2 (b3 - b2) ... from C''(0) = B''(1).
  const glm::vec3 p2 = kBefore.p1 + 4.0f * (kBefore.p3 - kBefore.p2);
  const Cubic c2{{11, 6, 2}, {15, 7, 2}, p2, {30, 9, 3}};
  EXPECT_EQ(joint(kBefore, c2).parametric, ParametricContinuity::c2);
  EXPECT_EQ(joint(kBefore, c2).geometric, GeometricContinuity::g2);
}

// A straight, and the same bent by an angle at the joint: below a milliradian it counts as none.
TEST(continuity, an_angle_below_a_milliradian_is_none) {
  const Cubic before{{1, 2, 3}, {4, 2, 3}, {7, 2, 3}, {10, 2, 3}};
  for (const auto& [angle, level] : {std::pair(0.9e-3, GeometricContinuity::g2),
                                     {1.1e-3, GeometricContinuity::g0},
                                     {-5e-3, GeometricContinuity::g0}}) {
    Cubic after;
    for (int i = 0; i < 4; ++i)
      (&after.p0)[i] = glm::vec3(10 + 3 * i * std::cos(angle), 2 + 3 * i * std::sin(angle), 3);
    EXPECT_NEAR(joint(before, after).angle, std::abs(angle), 1e-6);
    EXPECT_EQ(joint(before, after).geometric, level) << angle;
  }
}

TEST(continuity, names_are_those_of_the_field) {
  EXPECT_EQ(base::name_of(GeometricContinuity::g1), "G1");
  EXPECT_EQ(base::name_of(ParametricContinuity::c2), "C2");
}

}  // namespace continuity_test
}  // namespace coaster::curve
