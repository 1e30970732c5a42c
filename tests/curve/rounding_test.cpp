// Joints whose curvatures are set exactly, in double, and then rounded to float anywhere between 1 mm and 100 km.

#include "curve/continuity.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

namespace coaster::curve {
namespace rounding_test {

using glm::dvec3;
using Points = std::array<dvec3, 7>;  // two cubics with a common end, point 3

class Joints {
 public:
  explicit Joints(unsigned seed) : random_(seed) {}
  double between(double low, double high) { return std::uniform_real_distribution(low, high)(random_); }
  double spread(double low, double high) { return std::exp(between(std::log(low), std::log(high))); }
  dvec3 direction() {
    std::normal_distribution<double> normal;
    return glm::normalize(dvec3(normal(random_), normal(random_), normal(random_)));
  }

  // Returns a joint at the origin with that curvature before it and `after` times that behind it: at a handle l the
  // curvature is 2/3 h / l^2, with h the distance of the next control point from the tangent. Metres.
  Points joint(double curvature, double after) {
    const dvec3 t = direction(), n = glm::normalize(glm::cross(t, direction()));
    Points p{};
    for (const double side : {-1.0, 1.0}) {
      const auto at = [&](int i) -> dvec3& { return p[static_cast<std::size_t>(3 + (side < 0 ? -i : i))]; };
      const double l = spread(2, 20), k = curvature * (side > 0 ? after : 1);
      at(1) = side * l * t;
      at(2) = side * l * between(1.2, 3) * t + 1.5 * k * l * l * n;
      at(3) = at(2) + l * (side * t + 0.5 * direction());
    }
    return p;
  }

 private:
  std::mt19937 random_;
};

Cubic cubic(const Points& p, std::size_t first) {
  return {glm::vec3(p[first]), glm::vec3(p[first + 1]), glm::vec3(p[first + 2]), glm::vec3(p[first + 3])};
}
Points placed(Points p, double scale, dvec3 offset) {
  for (dvec3& point : p) point = scale * point + offset;
  return p;
}
// Returns the joint of the rounded points.
JointContinuity rounded(const Points& p) { return joint(cubic(p, 0), cubic(p, 3)); }
double bound(const Points& p) { return rounding_curvature(cubic(p, 0), 1.0) + rounding_curvature(cubic(p, 3), 0.0); }

dvec3 bend(dvec3 d, dvec3 dd) {  // B'' across B' by the length of B' squared
  return glm::cross(d, glm::cross(dd, d)) / (glm::dot(d, d) * glm::dot(d, d));
}
// Returns the jump of the curvature vector at point 3, from the definition.
double jump(const Points& p) {
  return glm::length(bend(3.0 * (p[4] - p[3]), 6.0 * (p[5] - 2.0 * p[4] + p[3])) -
                     bend(3.0 * (p[3] - p[2]), 6.0 * (p[1] - 2.0 * p[2] + p[3])));
}

TEST(rounding, the_oracle_sets_curvatures) {
  Joints joints(1);
  for (int i = 0; i < 1000; ++i) {
    const double k = joints.spread(1e-4, 0.1);
    EXPECT_LT(jump(joints.joint(k, 1)), 1e-12 * k + 1e-17);
    EXPECT_NEAR(jump(joints.joint(k, 1.5)), 0.5 * k, 1e-9 * k);
  }
}

TEST(rounding, a_joint_that_was_g2_before_it_was_rounded_is_g2) {
  Joints joints(2);
  int by_rounding = 0;
  for (int i = 0; i < 60'000; ++i) {
    const double scale = joints.spread(1e-3, 1e3), k = i % 5 == 0 ? 0 : joints.spread(1e-5, 0.1);
    const dvec3 offset = i % 7 == 0 ? dvec3(0) : joints.spread(1e-2, 1e5) * joints.direction();
    const Points p = placed(joints.joint(k, 1), scale, offset);
    const JointContinuity j = rounded(p);
    if (j.speed_ratio == 0 || glm::vec3(p[3]) == glm::vec3(p[2])) continue;  // rounded away
    EXPECT_EQ(j.geometric, GeometricContinuity::g2) << "scale " << scale << " at " << glm::length(offset) << " m, jump "
                                                    << j.curvature_jump << ", bound " << bound(p);
    const double size = std::max(glm::length(j.curvature_before), glm::length(j.curvature_after));
    by_rounding += j.curvature_jump > 1e-3 * size;
  }
  EXPECT_GT(by_rounding, 10'000) << "the bound of rounding is tried";
}

TEST(rounding, a_jump_of_two_thousandths_well_above_rounding_is_g1) {
  Joints joints(3);
  int tried = 0;
  for (int i = 0; i < 60'000; ++i) {
    const double scale = joints.spread(1e-3, 1e3), k = joints.spread(1e-5, 0.1);
    const dvec3 offset = joints.spread(1e-2, 1e5) * joints.direction();
    const Points p = placed(joints.joint(k, i % 2 ? 1.002 : 1 / 1.002), scale, offset);
    double ulp = 0, shortest = 1e9;  // m, of the largest coordinate; the shorter handle
    for (const dvec3 point : p)
      for (int axis = 0; axis < 3; ++axis) ulp = std::max(ulp, std::abs(point[axis]) * 0x1p-23);
    for (const std::size_t at : {2, 4}) shortest = std::min(shortest, glm::distance(p[at], p[3]));
    if (ulp * 30 / (shortest * shortest) > 1e-3 * k / scale) continue;
    ++tried;
    EXPECT_EQ(rounded(p).geometric, GeometricContinuity::g1)
        << "scale " << scale << " at " << glm::length(offset) << " m";
  }
  EXPECT_GT(tried, 5'000);
}

TEST(rounding, a_jump_just_below_a_thousandth_is_none_at_every_scale) {
  Joints joints(4);
  for (int i = 0; i < 10'000; ++i) {
    const double scale = joints.spread(1e-3, 1e3), k = joints.spread(1e-3, 0.1);
    EXPECT_EQ(rounded(placed(joints.joint(k, 1 + 0.9e-3), scale, dvec3(0))).geometric, GeometricContinuity::g2)
        << scale;
  }
}

// Searches the corners of what rounds to the same floats for the largest jump: each knot is an ulp off along each axis
// (rounded where it was planned, and again where it was carried, turned about the vertical), its handles with it, and
// each handle half an ulp more. Flips one error after the other while that helps.
double searched(const Points& p, Joints& joints) {
  constexpr std::size_t kMoved[][3] = {{0, 1, 1}, {1, 1, 1}, {2, 2, 2}, {2, 3, 4}, {4, 4, 4}, {5, 5, 5}, {5, 6, 6}};
  double most = 0;
  for (int start = 0; start < 8; ++start) {
    Points now = p;
    std::array<dvec3, 7> error{};
    const auto move = [&](std::size_t i, int axis, double by) {
      std::array<bool, 7> moved{};
      for (const std::size_t k : kMoved[i]) moved[k] = true;
      for (std::size_t k = 0; k < 7; ++k)
        if (moved[k]) now[k][axis] += by;
    };
    for (std::size_t i = 0; i < 7; ++i)
      for (int axis = 0; axis < 3; ++axis) {
        const auto x = static_cast<float>(std::abs(axis == 1 ? p[i].y : std::max(std::abs(p[i].x), std::abs(p[i].z))));
        error[i][axis] =
            (std::nextafter(x, INFINITY) - x) * (i % 3 == 0 ? 1 : 0.5) * (joints.between(-1, 1) < 0 ? -1 : 1);
        move(i, axis, error[i][axis]);
      }
    double best = jump(now);
    for (bool better = true; better;) {
      better = false;
      for (std::size_t i = 0; i < 7; ++i)
        for (int axis = 0; axis < 3; ++axis) {
          move(i, axis, -2 * error[i][axis]);
          if (const double other = jump(now); other > best) best = other, error[i][axis] *= -1, better = true;
          else move(i, axis, 2 * error[i][axis]);
        }
    }
    most = std::max(most, best);
  }
  return most;
}

TEST(rounding, the_bound_is_at_most_four_times_what_a_search_finds) {
  Joints joints(5);
  double least = 1e9, worst = 0;
  for (int i = 0; i < 2'000; ++i) {
    const double k = i % 5 == 0 ? 0 : joints.spread(1e-5, 0.1);
    const Points p = placed(joints.joint(k, 1), 1, joints.spread(1e2, 1e4) * joints.direction());
    const double ratio = bound(p) / searched(p, joints);
    least = std::min(least, ratio), worst = std::max(worst, ratio);
  }
  EXPECT_GE(least, 0.99);
  EXPECT_LE(worst, 4);
  RecordProperty("ratio", std::to_string(least) + " to " + std::to_string(worst));
}

}  // namespace rounding_test
}  // namespace coaster::curve
