#include "sim/plan/element_path.h"

#include <gtest/gtest.h>

#include "base/portable_math.h"
#include "sim/random_elements.h"
#include "world/element_rows.h"

namespace coaster::sim {
namespace element_path_test {

TEST(element_path, a_bend_turns_from_its_first_to_its_last_angle_and_its_curvature_is_the_derivative_of_the_angle) {
  for (const auto& [from, to, radius] :
       {std::tuple{0.0, 0.7, 20.0}, {0.9, -1.2, 7.0}, {-0.2, 6.0, 3.0}, {0.0, 0.01, 100.0}}) {
    const Bend bend{from, to, radius};
    EXPECT_NEAR(bend.angle(0), from, 1e-14);
    EXPECT_NEAR(bend.angle(bend.length()), to, 1e-14);
    EXPECT_EQ(bend.bend(0), 0);
    EXPECT_NEAR(bend.bend(bend.length()), 0, 1e-15);
    double most = 0;
    for (int i = 1; i < 400; ++i) {
      const double u = bend.length() * i / 400, h = 1e-5;
      EXPECT_NEAR((bend.angle(u + h) - bend.angle(u - h)) / (2 * h), bend.bend(u), 1e-6 / bend.radius + 1e-9);
      most = std::max(most, std::abs(bend.bend(u)));
    }
    EXPECT_LE(most, 1 / radius + 1e-15) << "the radius is the least there is";
  }
}

TEST(element_path, a_slight_bend_is_wide_enough_to_be_six_metres_long) {
  const Bend slight{0.3, 0.301, 5};
  EXPECT_NEAR(slight.length(), 6, 1e-9);
  EXPECT_GT(slight.radius, 1000);
  EXPECT_EQ((Bend{0.3, 0.3, 5}.length()), 0);
}

// Simpson's rule in long double, and libm: nothing of the program's own.
TEST(element_path, where_a_bend_ends_is_where_integrating_its_direction_ends) {
  const Bend bend{0.2, 2.4, 9};
  glm::dvec2 sum(0);
  constexpr int kSteps = 40'000;
  long double x = 0, y = 0;
  for (int i = 0; i <= kSteps; ++i) {
    const long double weight = i == 0 || i == kSteps ? 1
                               : i % 2               ? 4
                                                     : 2,
                      u = static_cast<long double>(bend.length()) * i / kSteps;
    const long double a = bend.angle(static_cast<double>(u));
    x += weight * std::cos(a), y += weight * std::sin(a);
  }
  sum = glm::dvec2(x, y) * (bend.length() / kSteps / 3);
  EXPECT_NEAR(bend.run_and_rise().x, sum.x, 1e-9);
  EXPECT_NEAR(bend.run_and_rise().y, sum.y, 1e-9);
  ElementPath path({1, 2, 3}, {std::cos(0.2), std::sin(0.2), 0}, glm::dvec3(0), {0, 1, 0});
  path.add(bend);
  EXPECT_NEAR(path.end().position.x, 1 + sum.x, 1e-9);
  EXPECT_NEAR(path.end().position.y, 2 + sum.y, 1e-9);
  EXPECT_NEAR(path.end().s, bend.length(), 1e-10);
}

TEST(element_path, tangent_and_curvature_are_the_derivatives_of_the_places_in_every_element) {
  test::RandomElements random(11);
  for (int i = 0; i < 120; ++i) {
    world::Element element = random.any();
    std::vector<std::string> lines;
    const ElementShape shape = element_shape(element, random.end(), lines);
    if (!shape.refusal.empty()) continue;
    const std::vector<ElementPoint>& p = shape.curve.points;
    const std::string what(base::row_of(element.kind).name);
    for (std::size_t k = 1; k < p.size(); ++k) {
      const double h = p[k].s - p[k - 1].s;
      ASSERT_GT(h, 0) << what;
      if (h > 1) break;  // long ones have coarser points than these bounds are made for
      const double bend = std::max(glm::length(p[k].curvature), glm::length(p[k - 1].curvature)),
                   change = glm::length(p[k].curvature - p[k - 1].curvature);
      // The trapezoid's error, generously.
      const double slack = h * h * (bend * bend + change / h) + 1e-9;
      EXPECT_LT(glm::length((p[k].position - p[k - 1].position) / h - 0.5 * (p[k].tangent + p[k - 1].tangent)), slack)
          << what << " " << k;
      EXPECT_LT(glm::length((p[k].tangent - p[k - 1].tangent) / h - 0.5 * (p[k].curvature + p[k - 1].curvature)),
                h * bend * bend + 0.5 * change + 1e-9)
          << what << " " << k;
      EXPECT_NEAR(glm::length(p[k].tangent), 1, 1e-12);
      EXPECT_NEAR(glm::length(p[k].up), 1, 1e-12);
      EXPECT_NEAR(glm::dot(p[k].tangent, p[k].up), 0, 1e-12);
      EXPECT_NEAR(glm::dot(p[k].tangent, p[k].curvature), 0, 1e-9 * bend + 1e-12);
    }
  }
}

TEST(element_path, begins_as_the_track_ends_and_ends_straight) {
  test::RandomElements random(12);
  int begun = 0;
  for (int i = 0; i < 400; ++i) {
    world::Element element = random.any();
    const TrackEnd end = random.end();
    std::vector<std::string> lines;
    const ElementShape shape = element_shape(element, end, lines);
    if (!shape.refusal.empty()) continue;
    ++begun;
    const ElementPoint &first = shape.curve.points.front(), &last = shape.curve.points.back();
    EXPECT_EQ(first.position, end.position);
    EXPECT_LT(glm::length(first.tangent - end.forward), 1e-12);
    EXPECT_LT(glm::length(first.up - end.up), 1e-9);
    EXPECT_LT(glm::length(first.curvature - end.curvature), 1e-9 + kStraightEnd);
    EXPECT_LT(glm::length(last.curvature), 1e-9);
    const ElementPoint& begin = shape.curve.points[shape.curve.lead];
    EXPECT_LT(glm::length(begin.curvature), 1e-9) << "the element proper begins without curvature";
  }
  EXPECT_GT(begun, 350);
}

}  // namespace element_path_test
}  // namespace coaster::sim
