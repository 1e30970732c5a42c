#include "curve/carried_frame.h"

#include <gtest/gtest.h>

#include "curve/frame_oracle.h"
#include "curve/random_cubics.h"

namespace coaster::curve {
namespace carried_frame_test {

using glm::dvec3;

Frame start_of(const Cubic& c) { return {unit_tangent(c, 0), perpendicular(unit_tangent(c, 0), {0.3, 1, -0.2})}; }

// Tight spatial cubics: all points anywhere within 40 m, loops, and near-cusps.
std::vector<Cubic> tight_cubics(int count, unsigned seed) {
  std::vector<Cubic> all = near_cusps(count, seed);
  for (const CubicSet& set : cubic_sets(count / 2, seed + 1))
    for (const Cubic& c : set.cubics)
      if (FrameOracle(c).least_speed() > 1e-4) all.push_back(c);
  return all;
}

TEST(carried_frame, is_within_the_bound_on_tight_spatial_cubics_in_one_piece_and_in_many) {
  std::mt19937 random(4);
  for (const Cubic& c : tight_cubics(200, 71)) {
    const Frame start = start_of(c);
    const double middle = (random() >> 8) / 16777216.0;
    const dvec3 wanted = FrameOracle(c).carried(start.up, 0, middle), last = FrameOracle(c).carried(wanted, middle, 1);
    const Frame there = carried(c, start, 0, middle), end = carried(c, there, middle, 1);
    ASSERT_LT(glm::length(there.up - wanted), 0.1 * kFrameBound) << middle;
    ASSERT_LT(glm::length(end.up - last), 0.1 * kFrameBound);
    ASSERT_LT(glm::length(carried(c, start, 0, 1).up - last), 0.1 * kFrameBound);
    ASSERT_EQ(end.forward, unit_tangent(c, 1));
    ASSERT_NEAR(glm::dot(end.up, end.forward), 0, 1e-12);
  }
}

TEST(carried_frame, in_a_plane_the_normal_stays_even_over_the_tightest_bend) {
  const Cubic c{{1, 2, 3}, {21.0f, 2, 23.0001f}, {1, 2, 23}, {21, 2, 3}};  // nearly a cusp, in y = 2
  const Frame end = carried(c, {unit_tangent(c, 0), {0, 1, 0}}, 0, 1);
  EXPECT_LT(glm::length(end.up - dvec3(0, 1, 0)), 1e-12);
}

TEST(carried_frame, a_step_is_off_by_less_than_its_bound_and_by_less_within_it) {
  int told = 0;
  double nearest = 0;
  for (const Cubic& c : tight_cubics(150, 73)) {
    const CoefficientsD curve = coefficients_d(c);
    for (const double from : {0.0, 0.3, 0.62})
      for (const double h : {0.2, 0.05, 1.0 / 32}) {
        const double bound = step_error(curve, from, h);
        if (!(bound < 1)) continue;
        const dvec3 tangent = unit_tangent(c, from), up = perpendicular(tangent, {0.1, 1, 0.4});
        for (const double share : {0.6, 1.0}) {
          const double to = from + share * h;
          const Frame step = transport({tangent, up}, point(c, from), point(c, to), unit_tangent(c, to));
          const double off = glm::length(step.up - FrameOracle(c).carried(up, from, to));
          ASSERT_LE(off, bound + 1e-9);
          if (bound > 1e-6) nearest = std::max(nearest, off / bound);
        }
        ++told;
      }
  }
  EXPECT_GT(told, 1000);
  EXPECT_GT(nearest, 0.1) << "a bound far above every error would cost steps";
}

TEST(carried_frame, the_bound_by_the_control_points_is_no_smaller) {
  int told = 0;
  for (const Cubic& c : random_cubics(2000, 74)) {
    const double all = steps_error(c, 32);
    double sum = 0;
    for (int i = 0; i < 32; ++i) sum += step_error(coefficients_d(c), i / 32.0, 1.0 / 32);
    if (!(all < 1)) continue;
    ASSERT_GE(all, sum * (1 - 1e-9));
    ++told;
  }
  EXPECT_GT(told, 500);
}

TEST(cusps, are_where_the_speed_vanishes_and_the_frame_makes_a_half_turn_about_up) {
  // In a plane, because a spatial cubic has no cusp; up has parts in the plane and across it.
  for (const Cubic& c :
       {Cubic{{0, 0, 0}, {1, 1, 0}, {0, 1, 0}, {1, 0, 0}}, Cubic{{0, 10, 0}, {20, 10, 20}, {0, 10, 20}, {20, 10, 0}}}) {
    const Cusps found = cusps(c);
    ASSERT_EQ(found.count, 1);
    EXPECT_NEAR(found.t[0], 0.5, 1e-12);
    const Frame start = start_of(c), before = carried(c, start, 0, 0.5 - 1e-6),
                after = carried(c, start, 0, 0.5 + 1e-6), at = carried(c, start, 0, 0.5);
    EXPECT_LT(glm::length(before.forward + after.forward), 1e-4);
    EXPECT_LT(glm::length(before.up - after.up), 1e-4);
    EXPECT_LT(glm::length(at.forward - after.forward), 1e-4);
    EXPECT_LT(glm::length(at.up - after.up), 1e-4);
    for (const double middle : {0.25, 0.5, 15.0 / 32, 0.8})
      EXPECT_LT(glm::length(carried(c, carried(c, start, 0, middle), middle, 1).up - carried(c, start, 0, 1).up), 1e-9);
    // A part of the curve on either side has no cusp.
    for (const auto& [from, to] : {std::pair{0.0, 0.4}, {0.1, 0.45}, {0.55, 0.9}, {0.6, 1.0}}) {
      const dvec3 tangent = unit_tangent(c, from), up = perpendicular(tangent, {0.3, 1, -0.2});
      const Frame part = carried(c, {tangent, up}, from, to);
      EXPECT_LT(glm::length(part.up - FrameOracle(c).carried(up, from, to)), 1e-6) << from;
      EXPECT_EQ(part.forward, unit_tangent(c, to));
    }
  }
  // B' = (t - 1/2) (a + (t - 1/2) b) with b against a: a quarter after the cusp the curve runs against its way out.
  const Cubic hook{{0, 5, 0}, {-12, 5, 6}, {-4, 5, 0}, {-8, 5, 6}};
  ASSERT_EQ(cusps(hook).count, 1);
  for (const double from : {0.55, 0.7, 0.8, 0.9}) {
    const dvec3 tangent = unit_tangent(hook, from), up = perpendicular(tangent, {0.3, 1, -0.2});
    EXPECT_LT(glm::length(carried(hook, {tangent, up}, from, 1).up - FrameOracle(hook).carried(up, from, 1)), 1e-6);
  }
  // A cusp elsewhere: B' = (t - u) (a + (t - u) b), with numbers that floats hold.
  for (const int eighth : {1, 2, 3, 5, 7}) {
    const float u = eighth / 8.0f;
    const glm::vec3 a(48, 96, 24), b(-96, 48, 192);
    const glm::vec3 h0 = -u * a + u * u * b, h1 = h0 + 0.5f * (a - 2 * u * b), h2 = (1 - u) * (a + (1 - u) * b);
    const Cubic c{{0, 0, 0}, h0 / 3.0f, (h0 + h1) / 3.0f, (h0 + h1 + h2) / 3.0f};
    if (cusps(c).count != 1) continue;  // the thirds of some were rounded
    EXPECT_NEAR(cusps(c).t[0], static_cast<double>(u), 1e-9);
  }
  const Cubic out_and_back{{0, 0, 0}, {8, 0, 0}, {-4, 0, 0}, {4, 0, 0}};
  const Cusps turns = cusps(out_and_back);
  ASSERT_EQ(turns.count, 2);
  EXPECT_NEAR(turns.t[0] + turns.t[1], 1, 1e-12);
  EXPECT_LT(glm::length(carried(out_and_back, start_of(out_and_back), 0, 1).up - start_of(out_and_back).up), 1e-12);
}

TEST(cusps, are_none_where_the_curve_is_only_tight_or_slow) {
  for (const Cubic& c : near_cusps(100, 75)) EXPECT_EQ(cusps(c).count, 0);
  EXPECT_EQ(cusps({{0, 0, 0}, {0, 0, 0}, {1, 0, 0}, {3, 1, 0}}).count, 0);  // a handle on its anchor
  EXPECT_EQ(cusps({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}}).count, 0);
  EXPECT_EQ(cusps({{5, 5, 5}, {5, 5, 5}, {5, 5, 5}, {5, 5, 5}}).count, 0);
}

TEST(carried_frame, degenerate_cubics_keep_frames_orthonormal_in_bounded_work) {
  for (const CubicSet& set : cubic_sets(60, 76))
    for (const Cubic& c : set.cubics) {
      const Frame end = carried(c, start_of(c), 0, 1);
      ASSERT_NEAR(glm::length(end.up), 1, 1e-12) << set.name;
      ASSERT_NEAR(glm::dot(end.up, end.forward), 0, 1e-12) << set.name;
    }
  for (const Cubic& c : degenerate_cubics()) {
    const Frame end = carried(c, start_of(c), 0, 1);
    ASSERT_NEAR(glm::length(end.up), 1, 1e-12);
    ASSERT_NEAR(glm::dot(end.up, end.forward), 0, 1e-12);
  }
}

}  // namespace carried_frame_test
}  // namespace coaster::curve
