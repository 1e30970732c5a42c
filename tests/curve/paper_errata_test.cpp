#include "curve/paper_errata.h"

#include <gtest/gtest.h>

#include <cmath>

#include "curve/arc_length.h"

namespace coaster::curve {
namespace paper_errata_test {

// Skew and off the origin.
const Cubic kBend{{3.3f, 7.1f, -2.9f}, {9.7f, 11.3f, -1.1f}, {17.9f, 6.7f, 4.3f}, {21.1f, 2.3f, 13.7f}};

TEST(paper_claims, gravesens_product_is_an_area_and_the_mean_is_within_its_bound) {
  const GravesenClaim claim = gravesen_claim(kBend);
  const double chord = glm::length(glm::dvec3(kBend.p3) - glm::dvec3(kBend.p0)), bound = claim.mean - chord;
  EXPECT_GT(bound, 0);  // (polygon - chord) / 2
  EXPECT_LE(std::abs(claim.mean - arc_length(kBend)), bound);
  // Twice as large: lengths double, the product becomes four times as much. That is what no length does.
  Cubic twice = kBend;
  for (glm::vec3* p : {&twice.p0, &twice.p1, &twice.p2, &twice.p3}) *p *= 2.0f;
  EXPECT_NEAR(gravesen_claim(twice).mean, 2 * claim.mean, 1e-5);
  EXPECT_NEAR(gravesen_claim(twice).product, 4 * claim.product, 1e-3);
}

TEST(paper_claims, one_difference_makes_a_line_that_is_right_for_uniform_straights_alone) {
  const Cubic straight{{1.5f, 2.5f, 3.5f}, {3.5f, 3.5f, 2.5f}, {5.5f, 4.5f, 1.5f}, {7.5f, 5.5f, 0.5f}};
  EXPECT_LT(line_claim(straight, 64), 1e-12);
  // For many steps the line is B(0) + t B'(0): its end is off by |B(0) + B'(0) - B(1)|.
  EXPECT_NEAR(line_claim(kBend, 64), glm::length(point(kBend, 0) + derivative(kBend, 0) - point(kBend, 1)), 0.5);
  EXPECT_EQ(line_claim(kBend, 1), 0);
}

TEST(paper_claims, frenet_flips_by_180_degrees_over_an_inflection) {
  // Plane and S-shaped: the curvature changes its sign in between.
  const Cubic s{{3.3f, 1.1f, 2.7f}, {13.3f, 11.1f, 2.7f}, {17.3f, -8.9f, 2.7f}, {29.3f, 2.1f, 2.7f}};
  const FlipClaim claim = flip_claim(s);
  EXPECT_TRUE(claim.defined);
  EXPECT_NEAR(claim.frenet_angle, M_PI, 1e-6);
  EXPECT_GT(claim.t, 0.3);
  EXPECT_LT(claim.t, 0.7);
  EXPECT_LT(flip_claim({{0, 0, 0}, {3, 4.1f, 0.2f}, {6, 4.1f, 0.9f}, {9, 0.3f, 1.1f}}).frenet_angle, 0.5);
}

TEST(paper_claims, two_near_inflections_do_not_cancel) {
  // Inflections at 0.4985 and 0.5015: B' = 60 (t - 1/2, (t - 1/2)^2 + 0.0015^2), nearly a cusp.
  const Cubic c{{0, 0, 0}, {-10, 5.000045f, 0}, {-10, 0.00009f, 0}, {0, 5.000135f, 0}};
  const FlipClaim claim = flip_claim(c);
  EXPECT_TRUE(claim.defined);
  EXPECT_NEAR(claim.frenet_angle, M_PI, 1e-6);
  EXPECT_NEAR(claim.t, 0.5, 0.003);
}

TEST(paper_claims, a_straight_has_no_frenet_normal) {
  const FlipClaim claim = flip_claim({{1, 2, 3}, {2, 2, 5}, {3, 2, 7}, {4, 2, 9}});
  EXPECT_FALSE(claim.defined);
  EXPECT_EQ(claim.frenet_angle, 0);
}

TEST(paper_claims, the_curve_leaves_a_crossing_polygon_but_no_convex_one) {
  // The handles cross: p0 p1 p2 p3 is a bow tie, and the curve runs through its open waist.
  const Cubic bow_tie{{0.7f, 0.3f, 1.1f}, {10.7f, 6.3f, 1.1f}, {0.7f, 6.3f, 1.1f}, {10.7f, 0.3f, 1.1f}};
  EXPECT_GT(pen_claim(bow_tie), 0.4);
  // A convex polygon is a pen.
  const Cubic arch{{0.7f, 0.3f, 1.1f}, {2.7f, 6.3f, 1.1f}, {8.7f, 6.3f, 1.1f}, {10.7f, 0.3f, 1.1f}};
  EXPECT_LT(pen_claim(arch), 1e-9);
}

TEST(paper_claims, degenerate_curves_give_finite_numbers) {
  const glm::vec3 p{5.5f, -3.3f, 1e5f}, q{5.5f, 9.7f, 1e5f};
  for (const Cubic& c : {Cubic{p, p, p, p}, Cubic{p, p, q, q}, Cubic{p, q, p, q}, Cubic{p, q, q, p}}) {
    const GravesenClaim g = gravesen_claim(c);
    const FlipClaim f = flip_claim(c);
    for (const double v : {g.product, g.mean, line_claim(c, 64), f.frenet_angle, pen_claim(c)})
      EXPECT_TRUE(std::isfinite(v));
  }
}

}  // namespace paper_errata_test
}  // namespace coaster::curve
