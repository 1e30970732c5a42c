// Tangent, up and roll of knots.
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "world/sample_documents.h"

namespace coaster::world {
namespace orientation_test {

void expect_orthonormal(const Knot& k) {
  const glm::dvec3 t(k.tangent), u(k.up);
  EXPECT_NEAR(glm::length(t), 1.0, 2e-7);
  EXPECT_NEAR(glm::length(u), 1.0, 2e-7);
  EXPECT_NEAR(glm::dot(t, u), 0.0, 2e-7);
}

TEST(orientation, turning_the_tangent_keeps_up_perpendicular) {
  Knot k = test::skew_knot({1.1f, 2.3f, 3.7f}, {0.3f, 0.2f, -0.7f}, 4, 4);
  for (int i = 0; i < 200; ++i) {
    set_tangent(k, {std::sin(i * 1.3f), std::cos(i * 2.1f), std::sin(i * 0.7f + 1)});
    expect_orthonormal(k);
  }
}

TEST(orientation, turning_the_tangent_is_the_least_rotation) {
  Knot k = test::skew_knot({1.1f, 2.3f, 3.7f}, {0.3f, 0.2f, -0.7f}, 4, 4);
  set_roll(k, 37.3);
  const glm::dvec3 from(k.tangent), up(k.up);
  set_tangent(k, {0.5f, -0.4f, 0.2f});
  // Rodrigues' formula about from x to, in libm's angles.
  const glm::dvec3 to(k.tangent), axis = glm::normalize(glm::cross(from, to));
  const double angle = std::acos(glm::dot(from, to));
  const glm::dvec3 expected =
      up * std::cos(angle) + glm::cross(axis, up) * std::sin(angle) + axis * glm::dot(axis, up) * (1 - std::cos(angle));
  EXPECT_NEAR(glm::distance(expected, glm::dvec3(k.up)), 0.0, 1e-6);
}

TEST(orientation, reversing_the_tangent_keeps_up) {
  Knot k = test::skew_knot({0, 0, 0}, {0.3f, 0.2f, -0.7f}, 4, 4);
  set_roll(k, -61.7);
  const Knot before = k;
  set_tangent(k, -k.tangent);
  EXPECT_EQ(k.tangent, -before.tangent);
  EXPECT_NEAR(glm::distance(k.up, before.up), 0.0f, 1e-6f);
}

TEST(orientation, the_same_direction_keeps_every_bit) {
  Knot k = test::skew_knot({0, 0, 0}, {0.3f, 0.2f, -0.7f}, 4, 4);
  const Knot before = k;
  set_tangent(k, {0.3f, 0.2f, -0.7f});
  EXPECT_EQ(k, before);
}

TEST(orientation, directions_without_length_are_ignored) {
  Knot k = test::skew_knot({0, 0, 0}, {0.3f, 0.2f, -0.7f}, 4, 4);
  const Knot before = k;
  const float nan = std::numeric_limits<float>::quiet_NaN(), inf = std::numeric_limits<float>::infinity();
  for (const glm::vec3 v : {glm::vec3(0), glm::vec3(1e-12f, 0, 0), glm::vec3(nan, 0, 1), glm::vec3(inf, 0, 0)}) {
    set_tangent(k, v);
    EXPECT_EQ(k, before);
  }
}

TEST(orientation, roll_reads_back_what_was_set) {
  for (const glm::vec3 tangent :
       {glm::vec3(0.3f, 0.2f, -0.7f), glm::vec3(1, 0, 0), glm::vec3(0.1f, -0.99f, 0), glm::vec3(0, 1, 0)}) {
    Knot k = test::skew_knot({0, 0, 0}, tangent, 4, 4);
    for (const double roll : {-179.3, -90.0, -12.7, 0.0, 45.1, 90.0, 180.0}) {
      set_roll(k, roll);
      expect_orthonormal(k);
      // One float ulp of up is 6e-8 rad, some 4e-6 degrees; 180 may read as -180.
      EXPECT_NEAR(std::remainder(roll_deg(k) - roll, 360.0), 0.0, 2e-5) << roll;
    }
  }
}

TEST(orientation, positive_roll_leans_to_the_riders_right) {
  Knot k = test::skew_knot({0, 0, 0}, {0, 0, -1}, 4, 4);  // looking along -Z the right is +X
  set_roll(k, 90);
  EXPECT_NEAR(glm::distance(k.up, glm::vec3(1, 0, 0)), 0.0f, 1e-6f);
}

TEST(orientation, whole_turns_of_roll_leave_the_same_bits) {
  Knot a = test::skew_knot({0, 0, 0}, {0.3f, 0.2f, -0.7f}, 4, 4), b = a;
  set_roll(a, 33.25), set_roll(b, 33.25 + 360 * 5);
  EXPECT_EQ(a, b);
}

TEST(orientation, what_is_off_by_a_ten_thousandth_is_repaired_as_well) {
  for (const float off : {1e-4f, -1e-4f, 3e-5f}) {
    Knot k;
    k.tangent = {0.6f * (1 + off), 0.8f * (1 + off), 0}, k.up = {-0.8f, 0.6f, 0};
    orthonormalise(k);
    expect_orthonormal(k);
    k.tangent = {0.6f, 0.8f, 0}, k.up = {-0.8f + 0.6f * off, 0.6f + 0.8f * off, 0};
    orthonormalise(k);
    expect_orthonormal(k);
    k.up = {-0.8f * (1 + off), 0.6f * (1 + off), 0};
    orthonormalise(k);
    expect_orthonormal(k);
  }
}

TEST(orientation, orthonormalise_repairs_and_is_idempotent) {
  Knot k;
  k.tangent = {3, 4, 0}, k.up = {1, 1, 1};
  orthonormalise(k);
  expect_orthonormal(k);
  EXPECT_NEAR(k.tangent.x, 0.6f, 1e-7f);
  const Knot once = k;
  orthonormalise(k);
  EXPECT_EQ(k, once);
  k.up = k.tangent;
  orthonormalise(k);
  expect_orthonormal(k);
  k.tangent = {0, 0, 0};
  orthonormalise(k);
  expect_orthonormal(k);
}

}  // namespace orientation_test
}  // namespace coaster::world
