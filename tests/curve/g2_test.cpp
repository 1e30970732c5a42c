#include "curve/g2.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

namespace coaster::curve {
namespace g2_test {

using glm::dvec3;

struct Chance {
  std::mt19937_64 bits;
  double number(double low, double high) { return low + (high - low) * (static_cast<double>(bits() >> 11) * 0x1p-53); }
  dvec3 vector(double size) { return {number(-size, size), number(-size, size), number(-size, size)}; }
};

// A joint of two segments of about 14 m with crooked handles, off the origin.
G2Problem crooked(Chance& chance, bool equal_lengths) {
  G2Problem p;
  const dvec3 o(113.7, 22.3, -91.1), t = glm::normalize(dvec3(0.9, 0.3, -0.2) + chance.vector(0.4));
  const double in = chance.number(3, 6), out = equal_lengths ? in : chance.number(3, 6);
  p.position = o;
  p.in_handle = o - t * in;
  p.out_handle = o + t * out;
  p.equal_lengths = equal_lengths;
  const auto side = [&](double way) {
    G2Side s;
    s.anchor = o + way * dvec3(12.9, 4.1, -3.3) + chance.vector(2.5);
    s.direction = -way * glm::normalize(dvec3(0.9, 0.3, -0.2) + chance.vector(0.4));
    s.length = chance.number(3, 6);
    return s;
  };
  p.before = side(-1);
  p.after = side(1);
  return p;
}

dvec3 across(dvec3 v, dvec3 unit) { return v - glm::dot(v, unit) * unit; }

// (2/3) of what the far handle is off the tangent, over the square of the handle: both curvature vectors at the joint.
std::array<dvec3, 2> curvatures(const G2Problem& p, const G2Solution& s) {
  const dvec3 t = glm::normalize(s.out_handle - s.in_handle),
              a = p.before.anchor + s.before_length * p.before.direction,
              b = p.after.anchor + s.after_length * p.after.direction;
  const double in = glm::length(s.position - s.in_handle), out = glm::length(s.out_handle - s.position);
  return {across(a - s.position, t) * (2.0 / 3.0) / (in * in), across(b - s.position, t) * (2.0 / 3.0) / (out * out)};
}
dvec3 far_curvature(const G2Side& side, double length, dvec3 handle) {
  return across(handle - side.anchor, side.direction) * (2.0 / 3.0) / (length * length);
}

// The oracle knows the set of all G2 joints in closed form: for any place, handle lengths and far handles the tangent
// must be that of in^2 (b - p) - out^2 (a - p). So a compass search over those seven numbers needs no conditions at
// all.
double movement_of(const G2Problem& p, const std::array<double, 7>& x) {
  const dvec3 place = p.position + dvec3(x[0], x[1], x[2]);
  const double in = x[3], out = p.equal_lengths ? x[3] : x[4];
  const double a = p.before.length_fixed ? p.before.length : x[5], b = p.after.length_fixed ? p.after.length : x[6];
  if (!(in > 0.05) || !(out > 0.05) || !(a > 0.05) || !(b > 0.05)) return 1e9;
  const dvec3 t = glm::normalize(in * in * (p.after.anchor + b * p.after.direction - place) -
                                 out * out * (p.before.anchor + a * p.before.direction - place));
  double sum = (a - p.before.length) * (a - p.before.length) + (b - p.after.length) * (b - p.after.length);
  for (const dvec3 d : {place - p.position, place - in * t - p.in_handle, place + out * t - p.out_handle})
    sum += glm::dot(d, d);
  return std::sqrt(sum);
}
double compass_search(const G2Problem& p, Chance& chance, double spread) {
  std::array<double, 7> x{chance.number(-spread, spread),
                          chance.number(-spread, spread),
                          chance.number(-spread, spread),
                          glm::length(p.position - p.in_handle) + chance.number(-spread, spread),
                          glm::length(p.out_handle - p.position) + chance.number(-spread, spread),
                          p.before.length,
                          p.after.length};
  double best = movement_of(p, x);
  for (double step = 0.5; step > 1e-7;) {
    bool better = false;
    // Random directions besides the axes: valleys are crooked.
    for (int i = 0; i < 28; ++i) {
      std::array<double, 7> y = x;
      if (i < 14) y[static_cast<std::size_t>(i / 2)] += i % 2 ? step : -step;
      else
        for (double& v : y) v += chance.number(-step, step);
      if (const double m = movement_of(p, y); m < best) best = m, x = y, better = true;
    }
    if (!better) step *= 0.5;
  }
  return best;
}

TEST(g2, gives_both_sides_one_curvature_vector_and_keeps_the_handles_on_a_line) {
  Chance chance{std::mt19937_64(41)};
  for (int i = 0; i < 400; ++i) {
    G2Problem p = crooked(chance, i % 2 == 1);
    p.before.length_fixed = p.after.length_fixed = i % 3 == 0;
    const G2Solution s = solve_g2(p);
    ASSERT_EQ(s.outcome, G2Outcome::solved) << i;
    const auto k = curvatures(p, s);
    EXPECT_LT(glm::length(k[0] - k[1]), 1e-7) << i;
    const dvec3 t = glm::normalize(s.out_handle - s.in_handle);
    EXPECT_LT(glm::length(across(s.position - s.in_handle, t)), 1e-9) << i;
    EXPECT_GT(glm::dot(s.position - s.in_handle, t), 0) << i;
    EXPECT_GT(glm::dot(s.out_handle - s.position, t), 0) << i;
    const double in = glm::length(s.position - s.in_handle), out = glm::length(s.out_handle - s.position);
    EXPECT_TRUE(!p.equal_lengths || std::abs(in - out) < 1e-9) << i;
    EXPECT_TRUE(!p.before.length_fixed || s.before_length == p.before.length) << i;
  }
}

// Of joints so crooked that handles would reverse, few are left unsolved.
TEST(g2, solves_nearly_all_of_very_crooked_joints) {
  Chance chance{std::mt19937_64(5)};
  int solved = 0;
  constexpr int kTries = 4000;
  for (int i = 0; i < kTries; ++i) {
    G2Problem p = crooked(chance, i % 2 == 1);
    for (G2Side* const side : {&p.before, &p.after}) {
      side->anchor += chance.vector(8), side->length = chance.number(0.75, 6), side->length_fixed = false;
      side->direction = glm::normalize(side->direction + chance.vector(1.2));
    }
    const dvec3 t = glm::normalize(dvec3(0.9, 0.3, -0.2) + chance.vector(1.6));
    p.in_handle = p.position - chance.number(0.75, 6) * t, p.out_handle = p.position + chance.number(0.75, 6) * t;
    if (p.equal_lengths) p.out_handle = 2.0 * p.position - p.in_handle;
    const G2Solution s = solve_g2(p);
    if (s.outcome != G2Outcome::solved) continue;
    ++solved;
    ASSERT_GT(glm::dot(s.out_handle - s.position, s.position - s.in_handle), 0) << i;
    ASSERT_GT(std::min(s.before_length, s.after_length), 0) << i;
  }
  EXPECT_GT(solved, kTries * 95 / 100) << solved;
}

TEST(g2, moves_no_more_than_a_search_over_all_g2_joints_finds) {
  Chance chance{std::mt19937_64(97)};
  for (int i = 0; i < 60; ++i) {
    G2Problem p = crooked(chance, i % 2 == 1);
    p.before.length_fixed = i % 3 == 0;
    p.after.length_fixed = i % 5 != 0;
    const G2Solution s = solve_g2(p);
    ASSERT_EQ(s.outcome, G2Outcome::solved) << i;
    double found = 1e9;
    for (const double spread : {0.0, 1.0, 1.0}) found = std::min(found, compass_search(p, chance, spread));
    // The search stops a little above the least; and it must come near, else it proves nothing.
    EXPECT_LE(s.movement, found + 1e-6) << i;
    EXPECT_NEAR(s.movement, found, 1e-2 * found + 1e-6) << i;
  }
}

TEST(g2, keeps_the_curvature_of_the_far_joints_or_the_handle) {
  Chance chance{std::mt19937_64(5)};
  int solved = 0;
  for (int i = 0; i < 200; ++i) {
    G2Problem p = crooked(chance, false);
    p.before.keep = G2Side::FarEndConstraint::curvature;
    p.before.curvature = far_curvature(p.before, p.before.length, p.in_handle);
    p.before.length_fixed = i % 2 == 0;
    if (i % 4 == 3) p.after.keep = G2Side::FarEndConstraint::handle;
    const G2Solution s = solve_g2(p);
    if (s.outcome != G2Outcome::solved) continue;
    ++solved;
    EXPECT_LT(glm::length(far_curvature(p.before, s.before_length, s.in_handle) - p.before.curvature), 1e-7) << i;
    EXPECT_TRUE(i % 4 != 3 || glm::length(s.out_handle - p.out_handle) < 1e-7) << i;
    const auto k = curvatures(p, s);
    EXPECT_LT(glm::length(k[0] - k[1]), 1e-6) << i;
  }
  EXPECT_GT(solved, 150);  // the others have no such shape nearby
}

TEST(g2, keeps_the_joint_in_its_place_when_told) {
  Chance chance{std::mt19937_64(12)};
  for (int i = 0; i < 50; ++i) {
    G2Problem p = crooked(chance, i % 2 == 0);
    p.position_fixed = true;
    const G2Solution s = solve_g2(p);
    ASSERT_EQ(s.outcome, G2Outcome::solved) << i;
    EXPECT_LT(glm::length(s.position - p.position), 1e-7) << i;
    EXPECT_LT(glm::length(curvatures(p, s)[0] - curvatures(p, s)[1]), 1e-7) << i;
  }
}

TEST(g2, a_joint_that_is_g2_already_does_not_move) {
  // A mirror-symmetric bend has equal curvature on both sides.
  G2Problem p;
  p.position = {7.7, 1.1, 3.3};
  p.in_handle = p.position - dvec3(4.1, 0, 0);
  p.out_handle = p.position + dvec3(4.1, 0, 0);
  p.before = {p.position + dvec3(-12.3, -5.1, 0.7), glm::normalize(dvec3(0.8, 0.6, 0.1)), 3.3};
  p.after = {p.position + dvec3(12.3, -5.1, 0.7), glm::normalize(dvec3(-0.8, 0.6, 0.1)), 3.3};
  const G2Solution s = solve_g2(p);
  EXPECT_EQ(s.outcome, G2Outcome::solved);
  EXPECT_LT(s.movement, 1e-9);
}

TEST(g2, refuses_handles_of_no_length_and_conditions_that_contradict) {
  Chance chance{std::mt19937_64(3)};
  G2Problem p = crooked(chance, false);
  p.in_handle = p.position;
  EXPECT_EQ(solve_g2(p).outcome, G2Outcome::degenerate);
  p = crooked(chance, false);
  p.after.anchor.y = NAN;
  EXPECT_EQ(solve_g2(p).outcome, G2Outcome::degenerate);
  // Every handle and the place held: nothing is left to move.
  p = crooked(chance, true);
  p.before.keep = p.after.keep = G2Side::FarEndConstraint::handle;
  p.position_fixed = true;
  const G2Solution s = solve_g2(p);
  EXPECT_EQ(s.outcome, G2Outcome::no_convergence);
  EXPECT_LE(s.iterations, 61);
}

}  // namespace g2_test
}  // namespace coaster::curve
