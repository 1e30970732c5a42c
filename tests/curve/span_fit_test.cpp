#include "curve/span_fit.h"

#include <gtest/gtest.h>

#include <cmath>

#include "curve/continuity.h"

namespace coaster::curve {
namespace span_fit_test {

using glm::dvec3;

// Known for circles (de Boor, Hollig, Sabin 1987): 4/3 tan(angle / 4) of the radius on both sides.
TEST(span_fit, handles_of_a_circular_arc_are_those_that_are_known) {
  for (const double angle : {0.1, 0.5, 1.0, 1.5}) {
    const double r = 17;
    const PathPoint from{0, {r, 0, 0}, {0, 1, 0}, {-1 / r, 0, 0}};
    const PathPoint to{r * angle,
                       {r * std::cos(angle), r * std::sin(angle), 0},
                       {-std::sin(angle), std::cos(angle), 0},
                       {-std::cos(angle) / r, -std::sin(angle) / r, 0}};
    // Curvature at both ends and symmetry: a solves D.n = a sin + 1.5 a^2 / r, with n the normal at the start.
    const double dn = r * (1 - std::cos(angle)), sine = std::sin(angle),
                 a = (-sine + std::sqrt(sine * sine + 6 * dn / r)) * r / 3;
    const HandleLengths found = handle_lengths(from, to);
    EXPECT_NEAR(found.out, a, 1e-6 * r);
    EXPECT_NEAR(found.in, a, 1e-6 * r);
    EXPECT_NEAR(found.out, 4.0 / 3 * std::tan(angle / 4) * r, 2e-3 * r * angle * angle * angle);
  }
}

// A helix about a skew axis, in closed form.
struct Helix {
  double radius = 11, climb = 0.35;  // m, rise over run
  dvec3 origin{3.1, -7.3, 12.7}, x = glm::normalize(dvec3(2, 1, -1)), z = glm::normalize(dvec3(1, 1, 3)),
                                 y = glm::cross(z, x);
  double stretch() const { return std::sqrt(1 + climb * climb); }
  PathPoint at(double s) const {
    const double a = s / (radius * stretch());
    const dvec3 outward = std::cos(a) * x + std::sin(a) * y, round = -std::sin(a) * x + std::cos(a) * y;
    return {s, origin + radius * outward + radius * a * climb * z, (round + climb * z) / stretch(),
            -outward / (radius * stretch() * stretch())};
  }
  SpanKnots nodes(int spans, double length) const {
    std::vector<PathPoint> points;
    for (int k = 0; k <= spans; ++k) points.push_back(at(length * k / spans));
    return span_nodes(points);
  }
};

TEST(span_fit, turned_tangents_make_the_joints_of_a_space_curve_g2) {
  const Helix helix;
  SpanKnots nodes = helix.nodes(9, 60);
  const double before = turn_tangents(nodes);
  EXPECT_GT(before, 1e-4) << "torsion leaves a jump";
  double jump = before;
  for (int step = 0; step < 4; ++step) jump = turn_tangents(nodes);
  EXPECT_LT(jump, 1e-11);
  for (std::size_t k = 0; k + 2 < nodes.place.size(); ++k) {
    const JointContinuity j = joint(span_cubic(nodes, k), span_cubic(nodes, k + 1));
    EXPECT_EQ(j.geometric, GeometricContinuity::g2) << k;
    EXPECT_LT(j.curvature_jump, 1e-5) << k << ": rounding to float alone";
  }
  for (std::size_t k = 0; k < nodes.place.size(); ++k) {
    EXPECT_EQ(nodes.place[k], helix.at(60.0 * static_cast<double>(k) / 9).position) << "knots stay on the path";
    EXPECT_NEAR(glm::length(nodes.tangent[k]), 1, 1e-15);
  }
  EXPECT_EQ(nodes.tangent.front(), helix.at(0).tangent) << "the ends do not turn";
  EXPECT_EQ(nodes.tangent.back(), helix.at(60).tangent);
}

TEST(span_fit, plane_paths_need_no_turning) {
  Helix circle;
  circle.climb = 0;
  SpanKnots nodes = circle.nodes(5, 50);
  const std::vector<dvec3> before = nodes.tangent;
  EXPECT_LT(turn_tangents(nodes), 1e-8);
  for (std::size_t k = 0; k < before.size(); ++k) EXPECT_LT(glm::distance(before[k], nodes.tangent[k]), 1e-7);
}

TEST(span_fit, straights_get_handles_of_a_third) {
  const dvec3 way = glm::normalize(dvec3(1, -2, 0.5));
  const HandleLengths found = handle_lengths({2, 2.0 * way, way, dvec3(0)}, {9.5, 9.5 * way, way, dvec3(0)});
  EXPECT_NEAR(found.out, 2.5, 1e-12);
  EXPECT_NEAR(found.in, 2.5, 1e-12);
}

}  // namespace span_fit_test
}  // namespace coaster::curve
