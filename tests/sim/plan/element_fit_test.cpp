#include "sim/plan/element_fit.h"

#include <gtest/gtest.h>

#include "base/tries.h"
#include "curve/continuity.h"
#include "sim/random_elements.h"
#include "world/element_rows.h"

namespace coaster::sim {
namespace element_fit_test {

using glm::dvec3;

curve::Cubic cubic_between(const world::Knot& a, const world::Knot& b) {
  return {a.position, a.position + a.tangent * a.out_length, b.position - b.tangent * b.in_length, b.position};
}

// By the program's nearest_point on every cubic nearby: another way than the one by which the fit measures itself.
double distance_to(const std::vector<world::Knot>& knots, dvec3 place) {
  double nearest = 1e9;
  for (std::size_t k = 0; k + 1 < knots.size(); ++k)
    nearest = std::min(nearest, curve::nearest_point(cubic_between(knots[k], knots[k + 1]), place).distance);
  return nearest;
}

TEST(element_fit, every_element_at_any_end_keeps_its_tolerances_and_every_joint_is_g2) {
  test::RandomElements random(21);
  int fitted = 0;
  for (int i = 0; i < test::tries(120); ++i) {
    const world::Element element = random.any();
    const TrackEnd end = random.end();
    const ElementPlan plan = plan_element(element, end);
    if (!plan.refusal.empty()) continue;
    ++fitted;
    const std::string what = std::string(base::row_of(element.kind).name) + " " + std::to_string(i);
    const std::vector<world::Knot>& knots = plan.fit.knots;
    ASSERT_TRUE(plan.fit.within) << what;
    double farthest = 0;
    for (const world::Knot& knot : knots) farthest = std::max(farthest, glm::length(dvec3(knot.position)));
    if (farthest > 2000) continue;  // float coordinates are no longer exact enough to promise it
    EXPECT_LE(plan.fit.error, kElementDistance + 2.5e-4) << what;
    EXPECT_LE(plan.fit.roll_error, kElementRoll_deg * M_PI / 180) << what;
    dvec3 before = plan.ideal.points.front().curvature;
    for (std::size_t k = 0; k + 1 < knots.size(); ++k) {
      const curve::Cubic c = cubic_between(knots[k], knots[k + 1]);
      EXPECT_LT(glm::length(curve::curvature_vector(c, 0) - before), 1e-3) << what << " knot " << k;
      if (k > 0) {
        EXPECT_EQ(curve::joint(cubic_between(knots[k - 1], knots[k]), c).geometric, curve::GeometricContinuity::g2)
            << what << " knot " << k;
      }
      before = curve::curvature_vector(c, 1);
    }
    const double handle = knots.back().in_length, rounding = farthest * 0x1p-24;
    EXPECT_LT(glm::length(before), kElementEnd + 8 * rounding / (handle * handle)) << what << ": it ends straight";
    const std::vector<ElementPoint>& points = plan.ideal.points;
    if (knots.size() > 16) continue;
    for (std::size_t k = 0; k < points.size(); k += 1 + points.size() / 20)
      EXPECT_LE(distance_to(knots, points[k].position), plan.fit.error + 1e-4) << what << " at " << points[k].s;
  }
  EXPECT_GT(fitted, test::tries(100));
}

// A climbing turn of 12 m whose torsion leaves a jump of curvature at the end of a single span.
ElementCurve climbing_turn(dvec3 start) {
  constexpr double kRadius = 30, kRise = 0.3;
  const double flat = 1 + kRise * kRise;
  ElementPath path(start, dvec3(1, kRise, 0) / std::sqrt(flat), dvec3(0, 0, -1 / (kRadius * flat)), {0, 1, 0});
  path.set_axes({1, 0, 0}, {0, 1, 0}, {0, 0, -1});
  path.add(12, [](double u) {
    const double sin = std::sin(u / kRadius), cos = std::cos(u / kRadius);
    return ElementDerivatives{{cos, kRise, sin}, {-sin / kRadius, 0, cos / kRadius}, dvec3(0), 0};
  });
  return path.finish(path.curve().length());
}

// There float rounds by 0.1 mm: too coarse for the curvature of a span of 0.4 m, fine enough for the others.
TEST(element_fit, a_short_span_excuses_only_the_joints_beside_it) {
  const ElementCurve curve = climbing_turn({1800, 5, 0});
  const double lengths[] = {0.4, curve.length() - 0.4};
  const ElementFit fit = fit_element(curve, lengths);
  ASSERT_TRUE(fit.within);
  const std::size_t last = fit.knots.size() - 1;
  EXPECT_LT(glm::distance(fit.knots[0].position, fit.knots[1].position), 0.6f);
  const dvec3 end = curve::curvature_vector(cubic_between(fit.knots[last - 1], fit.knots[last]), 1);
  EXPECT_LT(glm::distance(end, curve.points.back().curvature), kElementJump);
  EXPECT_GT(fit.jump, kElementJump) << "at the short span";
}

TEST(element_fit, the_first_knot_is_the_end_of_the_track_and_the_last_the_end_of_the_element) {
  test::RandomElements random(22);
  for (int i = 0; i < test::tries(60); ++i) {
    const TrackEnd end = random.end();
    const ElementPlan plan = plan_element(random.any(), end);
    if (!plan.refusal.empty()) continue;
    const ElementPoint& last = plan.ideal.points.back();
    EXPECT_EQ(plan.fit.knots.front().position, glm::vec3(end.position));
    EXPECT_LT(glm::length(dvec3(plan.fit.knots.front().tangent) - end.forward), 1e-6);
    EXPECT_EQ(plan.fit.knots.back().position, glm::vec3(last.position));
    EXPECT_LT(glm::length(dvec3(plan.fit.knots.back().tangent) - last.tangent), 1e-6);
    EXPECT_LT(glm::length(dvec3(plan.fit.knots.back().up) - last.up), 1e-6);
  }
}

// Sixth order: half the span, a 64th of the error (float leaves 1e-6 m of it).
TEST(element_fit, the_error_of_a_plane_curve_falls_with_the_sixth_power_of_the_span) {
  world::Element element = world::usual_element(world::ElementKind::curve);
  element.values[0] = 200, element.values[1] = 360;
  std::vector<std::string> lines;
  const ElementCurve curve = element_shape(element, TrackEnd{}, lines).curve;
  const std::size_t first = curve.breaks[1], many = curve.breaks[2] - first;  // the circle
  const auto error = [&](std::size_t spans) {
    std::vector<std::size_t> at{0, first};
    for (std::size_t i = 1; i <= spans; ++i) at.push_back(first + many * i / spans);
    at.push_back(curve.points.size() - 1);
    const Spans made = make_spans(curve, at);
    const std::span<const ElementPoint> points(curve.points);
    return check_span(points.subspan(at[1], at[2] - at[1] + 1), made.knots[1], made.knots[2]).error;
  };
  const double coarse = error(3), fine = error(6);
  EXPECT_GT(coarse / fine, 40);
  EXPECT_LT(coarse / fine, 90);
}

// The curvature of a climb falls to 0 without a slope. That of a cubic span cannot, so it may miss by 0.006 /m^2: above
// the rails that is 0.3 g along the track at 20 m/s.
TEST(element_fit, climbs_and_dives_begin_and_end_with_hardly_a_slope_of_curvature) {
  constexpr double kNear = 1e-3;  // of a span
  for (const world::ElementKind kind : {world::ElementKind::climb, world::ElementKind::dive})
    for (const double height : {4.0, 9.5, 14.4, 22.0})
      for (const double angle : {11.0, 16.0, 28.0, 45.0}) {
        world::Element element = world::usual_element(kind);
        element.values[0] = height, element.values[1] = angle;
        const ElementPlan plan = plan_element(element, TrackEnd{{0, 50, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 0}});
        ASSERT_TRUE(plan.fit.within);
        const std::vector<world::Knot>& knots = plan.fit.knots;
        for (const bool last : {false, true}) {
          const world::Knot &from = last ? knots[knots.size() - 2] : knots[0], &to = last ? knots.back() : knots[1];
          const curve::Cubic cubic{from.position, world::out_handle(from), world::in_handle(to), to.position};
          const double end = last ? 1 : 0, near = last ? 1 - kNear : kNear,
                       way = glm::distance(curve::point(cubic, end), curve::point(cubic, near));
          const double slope =
              glm::distance(curve::curvature_vector(cubic, end), curve::curvature_vector(cubic, near)) / way;
          EXPECT_LT(slope, 0.0065) << height << " m, " << angle << " degrees, " << (last ? "end" : "start");
        }
      }
}

TEST(element_fit, usual_elements_take_few_spans) {
  const int most[] = {1, 5, 15, 7, 5, 8, 10, 12, 8, 12, 16, 12, 12, 12, 21, 2};
  ASSERT_EQ(std::size(most), world::elements().size());
  for (std::size_t kind = 0; kind < std::size(most); ++kind) {
    const ElementPlan plan = plan_element(world::usual_element(static_cast<world::ElementKind>(kind)),
                                          TrackEnd{{0, 50, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 0}});
    EXPECT_LE(plan.spans(), static_cast<std::size_t>(most[kind])) << world::elements()[kind].name;
  }
}

}  // namespace element_fit_test
}  // namespace coaster::sim
