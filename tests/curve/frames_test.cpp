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

// A cubic in the plane y = 0 with its inflections near r and s (control points are in float): with
// B' = (t - c, (t - c)^2 - e), B' x B'' is (t - c)^2 + e.
Cubic with_inflections(double r, double s) {
  const double c = 0.5 * (r + s), e = -0.25 * (s - r) * (s - r);
  const auto slope = [&](double t) { return glm::dvec2(60 * (t - c), 60 * ((t - c) * (t - c) - e)); };
  const glm::dvec2 h0 = slope(0), h1 = h0 + glm::dvec2(30, -60 * c), h2 = slope(1);
  const auto at = [](glm::dvec2 p) { return glm::vec3(p.x, 0, p.y); };
  return {at({0, 0}), at(h0 / 3.0), at((h0 + h1) / 3.0), at((h0 + h1 + h2) / 3.0)};
}

// The roots in (0,1) of the quadratic B' x B'' of a cubic in the plane y = 0, in closed form from its control points.
std::vector<double> inflections(const Cubic& c) {
  using Real = long double;
  const auto cross = [](const glm::vec3& a, const glm::vec3& b, const glm::vec3& o, const glm::vec3& p) {
    return (Real(a.x) - Real(o.x)) * (Real(b.z) - Real(p.z)) - (Real(a.z) - Real(o.z)) * (Real(b.x) - Real(p.x));
  };
  // With the legs d0, d1, d2: (1-t)^2 d0 x d1 + t (1-t) d0 x d2 + t^2 d1 x d2.
  const Real a = cross(c.p1, c.p2, c.p0, c.p1), b = cross(c.p1, c.p3, c.p0, c.p2), d = cross(c.p2, c.p3, c.p1, c.p2);
  const Real q2 = a - b + d, q1 = b - 2 * a, root = q1 * q1 - 4 * q2 * a;
  std::vector<double> found;
  if (root <= 0) return found;
  const Real q = -0.5L * (q1 + std::copysign(std::sqrt(root), q1));
  for (const Real t : {q / q2, a / q})
    if (t > 0 && t < 1) found.push_back(static_cast<double>(t));
  std::sort(found.begin(), found.end());
  return found;
}

TEST(binormal, inflections_of_plane_cubics_are_the_roots_of_a_quadratic_however_near) {
  std::mt19937 random(31);
  const auto uniform = [&](double low, double high) { return low + (high - low) * (random() / 4294967296.0); };
  int counts[3] = {0, 0, 0};
  double nearest = 1;
  for (int i = 0; i < 3000; ++i) {
    Cubic c;
    if (i % 2 == 0) {
      for (glm::vec3* p : {&c.p0, &c.p1, &c.p2, &c.p3})
        *p = {static_cast<float>(uniform(-20, 20)), 0, static_cast<float>(uniform(-20, 20))};
    } else {
      const double at = uniform(0.1, 0.9), apart = std::pow(10.0, uniform(-4, -1));
      c = with_inflections(at - apart / 2, at + apart / 2);
    }
    const std::vector<double> wanted = inflections(c);
    const BinormalMinima minima = binormal_minima(binormal_curve(c));
    const BinormalTurns turns = binormal_turns(binormal_curve(c));
    ASSERT_EQ(static_cast<std::size_t>(minima.count), wanted.size()) << i;
    ++counts[minima.count];
    for (int k = 0; k < minima.count; ++k) {
      ASSERT_NEAR(minima.t[k], wanted[static_cast<std::size_t>(k)], 1e-9);
      ASSERT_NEAR(turns.at[k].angle, M_PI, 1e-9);
    }
    if (minima.count == 2) nearest = std::min(nearest, wanted[1] - wanted[0]);
  }
  for (const int count : counts) EXPECT_GT(count, 300);
  EXPECT_LT(nearest, 2e-4);
}

// Spatial: the minima of |B' x B''| and the turns there, by dense sampling of B' x B'' itself.
TEST(binormal, turns_of_nearly_plane_cubics_are_those_of_dense_sampling) {
  std::mt19937 random(32);
  const auto uniform = [&](double low, double high) { return low + (high - low) * (random() / 4294967296.0); };
  int both = 0;
  for (int i = 0; i < 300; ++i) {
    const double at = uniform(0.2, 0.8), apart = std::pow(10.0, uniform(-2.4, -1));
    Cubic c = with_inflections(at - apart / 2, at + apart / 2);
    for (glm::vec3* p : {&c.p1, &c.p2, &c.p3}) p->y = static_cast<float>(uniform(-1, 1) * apart * apart * apart);
    const auto b = [&](double t) { return glm::cross(derivative(c, t), second_derivative(c, t)); };
    constexpr int kSteps = 100'000;
    std::vector<double> wanted;
    double before = glm::length(b(0)), here = glm::length(b(1.0 / kSteps));
    for (int k = 1; k < kSteps; ++k) {
      const double next = glm::length(b((k + 1.0) / kSteps));
      if (here < before && here <= next) wanted.push_back(static_cast<double>(k) / kSteps);
      before = here, here = next;
    }
    const BinormalTurns turns = binormal_turns(binormal_curve(c));
    ASSERT_EQ(static_cast<std::size_t>(turns.count), wanted.size());
    for (int k = 0; k < turns.count; ++k) {
      const double t = wanted[static_cast<std::size_t>(k)];
      double from = std::max(0.0, t - 1.0 / 64), to = std::min(1.0, t + 1.0 / 64);
      if (turns.count == 2)
        (k == 0 ? to = std::min(to, (t + wanted[1]) / 2) : from = std::max(from, (t + wanted[0]) / 2));
      ASSERT_NEAR(turns.at[k].t, t, 2.0 / kSteps);
      ASSERT_NEAR(turns.at[k].angle, angle_between(b(from), b(to)), 0.02);
    }
    both += turns.count == 2 && turns.at[0].angle > 2 && turns.at[1].angle > 2;
  }
  EXPECT_GT(both, 100);
}

}  // namespace frames_test
}  // namespace coaster::curve
