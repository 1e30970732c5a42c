// Shapes at which formulas break: each has the result documented in docs/conventions.md, never NaN, never unbounded
// work.
#include <gtest/gtest.h>

#include <cmath>

#include "curve/arc_length.h"
#include "curve/arc_length_study.h"
#include "curve/continuity.h"
#include "curve/evaluators.h"
#include "curve/frames.h"
#include "curve/length_oracle.h"
#include "curve/random_cubics.h"

namespace coaster::curve {
namespace degenerate_test {

using glm::dvec3;

const glm::vec3 a(13.3f, -4.7f, 21.9f), x(7.1f, 0, 0), y(0, 5.3f, 0);
constexpr double kTimes[] = {0.0, 0.1, 0.31, 0.5, 0.77, 1.0};

bool finite(dvec3 v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

std::vector<CubicSet> all_kinds(int count, unsigned seed) {
  std::vector<CubicSet> sets = degenerate_sets(count, seed);
  for (CubicSet& set : cubic_sets(count, seed + 1)) sets.push_back(std::move(set));
  sets.push_back({"named", degenerate_cubics()});
  return sets;
}

// The longest leg of the control polygon, relative to which "small" is measured.
double size_of(const Cubic& c) {
  return std::max({glm::length(dvec3(c.p1) - dvec3(c.p0)), glm::length(dvec3(c.p2) - dvec3(c.p1)),
                   glm::length(dvec3(c.p3) - dvec3(c.p2))});
}

TEST(degenerate, every_evaluator_keeps_its_bound_and_its_ends_even_at_one_step) {
  for (const CubicSet& set : all_kinds(300, 91))
    for (const Cubic& c : set.cubics) {
      const PreparedCubic prepared = prepare(c);
      double extent = 0;
      for (const glm::vec3 p : {c.p0, c.p1, c.p2, c.p3}) extent = std::max(extent, glm::length(dvec3(p)));
      for (const Evaluator& row : evaluators())
        for (const int steps : {1, 7}) {
          std::vector<glm::vec3> points(static_cast<std::size_t>(steps) + 1), tangents(points.size());
          row.polyline(prepared, points, tangents);
          ASSERT_EQ(points.front(), c.p0) << row.name << set.name;
          ASSERT_EQ(points.back(), c.p3) << row.name << set.name;
          const double bound = row.error_bound(extent, 3 * size_of(c), steps);
          for (std::size_t i = 0; i < points.size(); ++i) {
            ASSERT_TRUE(finite(dvec3(tangents[i]))) << row.name << set.name;
            ASSERT_LE(glm::length(dvec3(points[i]) - point_long_double(c, static_cast<double>(i) / steps)), bound)
                << row.name << set.name;
          }
        }
    }
}

TEST(degenerate, every_length_is_finite_and_within_the_polygon_and_its_work_bounded) {
  for (const CubicSet& set : all_kinds(300, 92))
    for (const Cubic& c : set.cubics)
      for (const ArcLengthMethod& row : arc_length_methods())
        for (const int count : {1, 2, 65}) {
          const LengthEstimate estimate = row.measure(c, {count, 1e-5});
          ASSERT_TRUE(std::isfinite(estimate.length) && estimate.length >= 0) << row.name << set.name;
          ASSERT_TRUE(std::isfinite(estimate.error_bound)) << row.name << set.name;
          ASSERT_LE(estimate.length, 3 * 3.001 * size_of(c))
              << row.name << set.name;  // a sum of |B'| <= 3 * the greatest leg, by weights up to 1
          ASSERT_LE(estimate.evaluations, 20'000) << row.name << set.name;
          if (row.control != LengthControl::count) break;
        }
}

TEST(degenerate, every_tolerance_is_kept_with_bounded_work) {
  for (const CubicSet& set : degenerate_sets(1000, 93)) {
    std::vector<double> batch(set.cubics.size()), lengths;
    for (const Cubic& c : set.cubics) lengths.push_back(static_cast<double>(reference_length(c)));
    for (const double tolerance : {1e-3, 1e-6, 1e-9, 1e-12}) {
      arc_lengths(set.cubics, tolerance, batch);
      for (std::size_t i = 0; i < batch.size(); ++i) {
        const LengthEstimate one = measure_arc_length(set.cubics[i], 0, 1, tolerance);
        const double exact = lengths[i];
        ASSERT_LE(std::abs(one.length - exact), tolerance * exact) << set.name << i << " to " << tolerance;
        ASSERT_LE(std::abs(batch[i] - exact), tolerance * exact) << set.name << i << " at once to " << tolerance;
        ASSERT_LE(one.evaluations, 4000) << set.name;
      }
    }
  }
}

TEST(degenerate, distance_and_parameter_invert_each_other) {
  for (const CubicSet& set : all_kinds(400, 94))
    for (const Cubic& c : set.cubics) {
      const ArcLengthMap map(c);
      const double allowed = std::min(1e-9, 1e-9 * std::max(map.length(), 1e-3));
      double last = 0;
      for (const double share : {0.0, 0.07, 0.5, 0.83, 1.0}) {
        const double s = share * map.length(), t = map.parameter(s);
        ASSERT_TRUE(t >= last && t <= 1) << set.name;
        ASSERT_NEAR(map.distance(t), s, allowed) << set.name;
        last = t;
      }
    }
}

TEST(degenerate, tangents_frames_and_curvature_are_never_nan) {
  for (const CubicSet& set : all_kinds(1000, 95))
    for (const Cubic& c : set.cubics) {
      Frame frame{unit_tangent(c, 0), perpendicular(unit_tangent(c, 0), {0, 1, 0})};
      dvec3 last(c.p0);
      for (const double t : kTimes) {
        const dvec3 tangent = unit_tangent(c, t), here = point(c, t);
        ASSERT_NEAR(glm::length(tangent), 1, 1e-12) << set.name;
        const double k = curvature(c, t);
        ASSERT_TRUE(std::isfinite(k) && k >= 0) << set.name;
        if (const auto f = frenet(c, t)) {
          ASSERT_TRUE(finite(f->normal) && finite(f->binormal) && std::isfinite(f->torsion)) << set.name;
          ASSERT_NEAR(glm::dot(f->tangent, f->normal), 0, 1e-9) << set.name;
        }
        frame = transport(frame, last, here, tangent);
        ASSERT_NEAR(glm::length(frame.up), 1, 1e-12) << set.name;
        ASSERT_NEAR(glm::dot(frame.up, frame.forward), 0, 1e-12) << set.name;
        last = here;
      }
    }
}

TEST(degenerate, splits_add_up_and_the_nearest_point_is_no_farther_than_the_ends) {
  std::mt19937 random(96);
  std::uniform_real_distribution<double> place(-100, 100), share(0, 1);
  for (const CubicSet& set : all_kinds(1000, 96))
    for (const Cubic& c : set.cubics) {
      const SplitCubic halves = split(c, share(random));
      const double ulp = 1e-7 * (glm::length(dvec3(c.p0)) + size_of(c)),
                   whole = arc_length(c);  // the halves are rounded to float
      ASSERT_NEAR(arc_length(halves.left) + arc_length(halves.right), whole, 8 * ulp + 1e-9 * whole) << set.name;
      const dvec3 target = dvec3(c.p0) + dvec3{place(random), place(random), place(random)};
      const NearestPoint near = nearest_point(c, target);
      ASSERT_TRUE(near.t >= 0 && near.t <= 1) << set.name;
      ASSERT_LE(near.distance, std::min(glm::length(target - dvec3(c.p0)), glm::length(target - dvec3(c.p3))))
          << set.name;
      ASSERT_NEAR(near.distance, glm::length(target - point(c, near.t)), 1e-9) << set.name;
      const JointContinuity j = joint(halves.left, halves.right);
      ASSERT_EQ(j.gap, 0) << set.name;
      ASSERT_TRUE(std::isfinite(j.angle) && std::isfinite(j.speed_ratio) && std::isfinite(j.curvature_jump))
          << set.name;
    }
}

// --- the documented results, shape by shape
// ---------------------------------------------------------------------------

TEST(degenerate, four_equal_points_have_no_length_and_point_along_x) {
  const Cubic c{a, a, a, a};
  EXPECT_EQ(arc_length(c), 0);
  EXPECT_EQ(ArcLengthMap(c).parameter(1), 0);
  EXPECT_EQ(unit_tangent(c, 0.4), dvec3(1, 0, 0));
  EXPECT_EQ(curvature(c, 0.4), 0);
  EXPECT_FALSE(curvature_if_any(c, 0.4));
  EXPECT_FALSE(frenet(c, 0.4));
  EXPECT_EQ(nearest_point(c, dvec3(a) + dvec3(0, 3, 4)).distance, 5);
}

TEST(degenerate, a_handle_on_its_anchor_points_to_the_next_control_point) {
  const Cubic c{a, a, a + y, a + x};
  EXPECT_LT(glm::length(unit_tangent(c, 0) - dvec3(0, 1, 0)), 1e-6);
  EXPECT_EQ(curvature(c, 0), 0);  // B' = 0: stands for no number
  EXPECT_FALSE(curvature_if_any(c, 0)) << "unbounded: it grows as 1/t";
  EXPECT_GT(*curvature_if_any(c, 1e-6), 1e3);
  EXPECT_FALSE(frenet(c, 0));
  const Cubic end{a + x, a + y, a, a};
  EXPECT_LT(glm::length(unit_tangent(end, 1) - dvec3(0, -1, 0)), 1e-6);
  const Cubic both{a, a, a + x, a + x};  // a straight, slow at both ends
  EXPECT_LT(glm::length(unit_tangent(both, 0) - dvec3(1, 0, 0)), 1e-6);
  EXPECT_LT(glm::length(unit_tangent(both, 1) - dvec3(1, 0, 0)), 1e-6);
  EXPECT_EQ(curvature_if_any(both, 0), 0) << "the limit";
  EXPECT_EQ(curvature_if_any(both, 1), 0);
  EXPECT_EQ(curvature_if_any({a, a, a, a + x}, 0), 0);
  EXPECT_NEAR(arc_length(both), glm::length(dvec3(both.p3) - dvec3(both.p0)), 1e-12);
}

TEST(degenerate, an_interior_cusp_is_measured_in_full_and_points_onward) {
  const Cubic c{{0, 0, 0}, {1, 1, 0}, {0, 1, 0}, {1, 0, 0}};  // B'(1/2) = 0, arriving upwards and leaving downwards
  EXPECT_NEAR(arc_length(c), 2 * std::sqrt(2.0) - 1, 2e-12);
  EXPECT_NEAR(arc_length(c, 0, 0.5), std::sqrt(2.0) - 0.5, 2e-12);
  EXPECT_NEAR(ArcLengthMap(c).parameter(std::sqrt(2.0) - 0.5), 0.5, 1e-5);  // s ~ (t - 1/2)^2 there
  EXPECT_LT(glm::length(unit_tangent(c, 0.5) - dvec3(0, -1, 0)), 1e-12);
  EXPECT_EQ(curvature(c, 0.5), 0);
  EXPECT_FALSE(curvature_if_any(c, 0.5));
  EXPECT_GT(*curvature_if_any(c, 0.4999), 100);
  EXPECT_FALSE(frenet(c, 0.5));
  const Cubic turning{{0, 0, 0}, {8, 0, 0}, {-4, 0, 0}, {4, 0, 0}};  // a straight, B' = 24 (1 - 5 t + 5 t^2)
  for (const double t : {0.5 - std::sqrt(0.05), 0.5 + std::sqrt(0.05)}) EXPECT_FALSE(curvature_if_any(turning, t));
  EXPECT_EQ(curvature_if_any(turning, 0.4), 0);
  EXPECT_EQ(curvature_if_any({{0, 0, 0}, {4, 0, 0}, {0, 0, 0}, {4, 0, 0}}, 0.5), 0) << "it stops and goes on";
}

TEST(degenerate, crossed_handles_make_a_loop_that_is_measured_like_any_curve) {
  const Cubic c{a, a + 1.7f * x + y, a + y - 0.6f * x, a + x};
  EXPECT_NEAR(arc_length(c), static_cast<double>(LengthOracle(c).length()), 1e-11);
  EXPECT_GT(arc_length(c), 1.5 * glm::length(dvec3(c.p3) - dvec3(c.p0)));
}

TEST(degenerate, a_vertical_straight_has_no_curvature_and_a_steady_frame) {
  const Cubic c{a, a + y, a + 2.0f * y, a + 3.0f * y};
  Frame frame{{0, 1, 0}, perpendicular({0, 1, 0}, {0, 1, 0})};
  const dvec3 up = frame.up;
  dvec3 last(c.p0);
  for (const double t : kTimes) {
    EXPECT_LT(glm::length(unit_tangent(c, t) - dvec3(0, 1, 0)), 1e-12);
    EXPECT_NEAR(curvature(c, t), 0, 1e-6);
    EXPECT_FALSE(frenet(c, t));
    frame = transport(frame, last, point(c, t), unit_tangent(c, t));
    EXPECT_LT(glm::length(frame.up - up), 1e-12);
    last = point(c, t);
  }
}

TEST(degenerate, a_closed_loop_with_opposed_ends_has_length_but_no_chord) {
  const Cubic c{a, a + x + y, a - x + y, a};
  EXPECT_NEAR(arc_length(c), static_cast<double>(LengthOracle(c).length()), 1e-11);
  const NearestPoint start = nearest_point(c, dvec3(a));
  EXPECT_LT(start.distance, 1e-6);
  EXPECT_LT(std::min(start.t, 1 - start.t), 1e-6);
  const JointContinuity j = joint(c, c);  // closes on itself with a corner
  EXPECT_EQ(j.gap, 0);
  EXPECT_EQ(j.geometric, GeometricContinuity::g0);
  const Cubic flat{a, a + x, a - x, a};  // the same squeezed to a line: out, through and back
  EXPECT_NEAR(arc_length(flat), 2 / std::sqrt(3.0) * glm::length(dvec3(flat.p1) - dvec3(flat.p0)), 1e-5);
}

TEST(degenerate, an_inflection_has_no_curvature_and_the_frenet_normal_flips_across_it) {
  const Cubic c{a, a + x + y, a + x - y, a + 2.0f * x};  // inflects at 1/2
  EXPECT_LT(curvature(c, 0.5), 1e-6);
  const auto before = frenet(c, 0.45), after = frenet(c, 0.55);
  ASSERT_TRUE(before && after);
  EXPECT_LT(glm::dot(before->normal, after->normal), -0.9);
}

TEST(degenerate, a_straight_with_uneven_speed_has_the_length_of_its_chord) {
  const Cubic c{a, a + 0.1f * x, a + 2.9f * x, a + 3.0f * x};
  EXPECT_NEAR(arc_length(c), glm::length(dvec3(c.p3) - dvec3(c.p0)), 1e-12);
  EXPECT_NEAR(ArcLengthMap(c).parameter(arc_length(c) / 2), 0.5, 1e-6);
  EXPECT_LT(curvature(c, 0.3), 1e-5);
}

TEST(degenerate, a_nanometre_is_measured_with_the_same_relative_error) {
  const Cubic c{{1e-10f, 0, 0}, {3e-10f, 1e-10f, 0}, {6e-10f, 0, 0}, {1e-9f, 0, 0}};
  const auto exact = static_cast<double>(LengthOracle(c).length());
  EXPECT_NEAR(arc_length(c), exact, 1e-12 * exact);
  EXPECT_NEAR(ArcLengthMap(c).length(), exact, 1e-12 * exact);
  EXPECT_LT(glm::length(unit_tangent(c, 0) - glm::normalize(dvec3(2, 1, 0))), 1e-6);
}

TEST(degenerate, at_a_hundred_kilometres_the_rounded_control_points_are_measured_exactly) {
  const Cubic c{
      {1e5f, 1e5f, -1e5f}, {100010.0f, 1e5f, -1e5f}, {100020.0f, 100005.0f, -1e5f}, {100030.0f, 100005.0f, -99990.0f}};
  Cubic home = c;  // the same offsets at the origin: all are whole numbers, so nothing rounds
  for (glm::vec3* p : {&home.p0, &home.p1, &home.p2, &home.p3}) *p -= c.p0;
  EXPECT_EQ(arc_length(c), arc_length(home));
  EXPECT_EQ(ArcLengthMap(c).parameter(17.3), ArcLengthMap(home).parameter(17.3));
}

}  // namespace degenerate_test
}  // namespace coaster::curve
