#include "curve/frames.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/portable_math.h"
#include "curve/random_cubics.h"

namespace coaster::curve {
namespace frames_test {

using glm::dvec3;

// A helix of radius r and rise c per radian: curvature r/(r^2+c^2), torsion c/(r^2+c^2). Its rotation-minimising frame
// turns by -torsion against the Frenet frame per metre.
struct Helix {
  double r = 9.3, c = 2.1;
  dvec3 point(double a) const { return {31.7 + r * std::cos(a), 5.1 + c * a, -12.9 + r * std::sin(a)}; }
  dvec3 tangent(double a) const { return glm::normalize(dvec3(-r * std::sin(a), c, r * std::cos(a))); }
  dvec3 normal(double a) const { return {-std::cos(a), 0, -std::sin(a)}; }
};

double transported_error(int steps) {
  const Helix helix;
  const double turn = 2 * base::kPi;
  Frame frame{helix.tangent(0), helix.normal(0)};
  for (int i = 1; i <= steps; ++i)
    frame = transport(frame, helix.point(turn * (i - 1) / steps), helix.point(turn * i / steps),
                      helix.tangent(turn * i / steps));
  // torsion x length, with the sign of this parametrisation's handedness
  const dvec3 b = glm::cross(helix.tangent(turn), helix.normal(turn));
  const double angle = helix.c / std::sqrt(helix.r * helix.r + helix.c * helix.c) * turn;
  const double found = std::atan2(glm::dot(frame.up, b), glm::dot(frame.up, helix.normal(turn)));
  return std::abs(std::remainder(std::abs(found) - std::abs(std::remainder(angle, turn)), turn));
}

TEST(frames, double_reflection_is_exact_to_fourth_order_on_a_helix) {
  const double coarse = transported_error(32), fine = transported_error(64);
  EXPECT_LT(fine, 1e-7);
  EXPECT_GT(coarse / fine, 12);  // 16 for fourth order
  EXPECT_LT(coarse / fine, 20);
}

TEST(frames, transport_keeps_frames_orthonormal_even_on_degenerate_steps) {
  const Frame start{{1, 0, 0}, {0, 0, 1}};
  for (const dvec3 to : {dvec3(0, 0, 0), dvec3(1e-13, 0, 0), dvec3(3, 1, 2), dvec3(-3, 0, 0)})
    for (const dvec3 tangent :
         {dvec3(1, 0, 0), dvec3(-1, 0, 0), dvec3(0, 1, 0), glm::normalize(dvec3(1, 2, 3)), dvec3(0, 0, 1)}) {
      const Frame f = transport(start, {0, 0, 0}, to, tangent);
      EXPECT_NEAR(glm::length(f.up), 1, 1e-12);
      EXPECT_NEAR(glm::dot(f.up, tangent), 0, 1e-12);
    }
}

TEST(frames, frenet_gives_curvature_and_torsion_of_a_twisted_cubic) {
  // (t, t^2, t^3) scaled by 10: at t = 0 curvature 2/10 and torsion 3/10.
  const Cubic c{{0, 0, 0}, {10 / 3.0f, 0, 0}, {20 / 3.0f, 10 / 3.0f, 0}, {10, 10, 10}};
  const auto f = frenet(c, 0);
  ASSERT_TRUE(f);
  EXPECT_NEAR(f->curvature, 0.2, 1e-6);
  EXPECT_NEAR(f->torsion, 0.3, 1e-6);
  EXPECT_LT(glm::length(f->tangent - dvec3(1, 0, 0)), 1e-6);
  EXPECT_LT(glm::length(f->normal - dvec3(0, 1, 0)), 1e-6);
  EXPECT_LT(glm::length(f->binormal - dvec3(0, 0, 1)), 1e-6);
}

TEST(frames, frenet_is_undefined_on_straight_lines_and_flips_across_an_inflection) {
  EXPECT_FALSE(frenet({{0, 0, 0}, {1, 1, 0}, {2, 2, 0}, {3, 3, 0}}, 0.4));
  const Cubic s{{0, 0, 0}, {4, 4, 0}, {8, -4, 0}, {12, 0, 0}};  // inflection at t = 1/2
  EXPECT_FALSE(frenet(s, 0.5));
  EXPECT_LT(glm::dot(frenet(s, 0.49)->normal, frenet(s, 0.51)->normal), -0.99);
  for (const Cubic& c : degenerate_cubics())
    for (double t : {0.0, 0.5, 1.0}) {
      const auto f = frenet(c, t);
      EXPECT_TRUE(!f || std::isfinite(f->curvature + f->torsion + f->normal.x));
    }
}

TEST(frames, the_least_rotation_takes_one_vector_to_the_other_and_leaves_their_normal) {
  const dvec3 a = glm::normalize(dvec3(1, 2, -3)), b = glm::normalize(dvec3(-2, 0.3, 1)),
              axis = perpendicular(a, {0, 1, 0});
  EXPECT_LT(glm::length(least_rotation(a, b, a, axis) - b), 1e-14);
  const dvec3 n = glm::normalize(glm::cross(a, b));
  EXPECT_LT(glm::length(least_rotation(a, b, n, axis) - n), 1e-14);
  EXPECT_LT(glm::length(least_rotation(a, -a, axis, axis) - axis), 1e-14);  // the half turn about the axis
  EXPECT_LT(glm::length(least_rotation(a, -a, a, axis) + a), 1e-14);
}

TEST(frames, rotations_are_right_handed_and_signed_angles_undo_them) {
  EXPECT_LT(glm::length(rotate({1, 0, 0}, {0, 0, 1}, base::kPi / 2) - dvec3(0, 1, 0)), 1e-15);
  const dvec3 axis = glm::normalize(dvec3(1, -2, 0.5)), v = perpendicular(axis, {0, 1, 0});
  for (double angle : {-3.0, -1.2, 0.0, 0.4, 3.1})
    EXPECT_NEAR(signed_angle(v, rotate(v, axis, angle), axis), angle, 1e-14);
}

TEST(frames, perpendicular_is_unit_for_every_wish) {
  for (const dvec3 f : {dvec3(0, 1, 0), dvec3(0, -1, 0), glm::normalize(dvec3(1e-9, 1, 0)), dvec3(1, 0, 0)})
    for (const dvec3 wish : {dvec3(0, 1, 0), dvec3(0, 0, 0), f, -f}) {
      const dvec3 up = perpendicular(f, wish);
      EXPECT_NEAR(glm::length(up), 1, 1e-12);
      EXPECT_NEAR(glm::dot(up, f), 0, 1e-12);
    }
}

// |B' x B''| by the derivatives themselves, at 20,000 places.
TEST(binormal, minima_are_those_of_a_fine_search) {
  int found_some = 0;
  for (const Cubic& c : random_cubics(200, 17, 20, 9)) {
    const auto size = [&](double t) { return glm::length(glm::cross(derivative(c, t), second_derivative(c, t))); };
    constexpr int kSteps = 20'000;
    std::vector<double> wanted;
    for (int i = 1; i < kSteps; ++i) {
      const double t = static_cast<double>(i) / kSteps;
      if (size(t) < size(t - 1.0 / kSteps) && size(t) <= size(t + 1.0 / kSteps)) wanted.push_back(t);
    }
    if (wanted.size() == 2 && wanted[1] - wanted[0] < 1.0 / 16) continue;
    const BinormalMinima minima = binormal_minima(binormal_curve(c));
    ASSERT_EQ(static_cast<std::size_t>(minima.count), wanted.size());
    for (std::size_t i = 0; i < wanted.size(); ++i) EXPECT_NEAR(minima.t[i], wanted[i], 1.0 / kSteps);
    found_some += minima.count;
  }
  EXPECT_GT(found_some, 40);
}

}  // namespace frames_test
}  // namespace coaster::curve
