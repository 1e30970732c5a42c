#include "sim/study/track_errata.h"

#include <gtest/gtest.h>

#include <cmath>

#include "sim/ride/ride.h"
#include "sim/tracks.h"

namespace coaster::sim {
namespace errata_test {

TEST(errata, every_name_has_its_row_with_texts_and_units) {
  const DerivedTrack derived = test::derived_of(test::sample_document());
  const auto all = errata(derived, derived.order[1], 17.3, 64);
  for (std::size_t i = 0; i < all.size(); ++i) {
    EXPECT_EQ(all[i].name, kErrata[i]);
    EXPECT_FALSE(all[i].claim.empty() || all[i].explanation.empty() || all[i].unit.empty() || all[i].wrong_unit.empty())
        << all[i].name;
    EXPECT_TRUE(std::isfinite(all[i].right) && std::isfinite(all[i].wrong)) << all[i].name;
    EXPECT_EQ(erratum(derived, derived.order[1], 17.3, 64, kErrata[i])->right, all[i].right);
  }
  EXPECT_FALSE(erratum(derived, derived.order[1], 17.3, 64, "gravity"));
}

TEST(errata, a_cart_at_rest_on_a_straight_slope_freezes_in_the_paper_and_falls_by_half_a_t_squared) {
  // 26 m long, falling 10 m: a = g 10/26 for half a second.
  const DerivedTrack derived = test::derived_of(test::straight_document({1.1f, 12.3f, 2.7f}, {25.1f, 2.3f, 2.7f}));
  const Erratum e = *erratum(derived, derived.order[0], 0, 64, "frozen");
  EXPECT_EQ(e.wrong, 0);
  EXPECT_NEAR(e.right, 0.5 * 9.81 * 10.0 / 26.0 * 0.25, 1e-5);
}

TEST(errata, a_straight_into_a_c1_circle_jumps_by_the_closed_form) {
  // v^2 / (R g): 5.4 g at R = 7.5 m and 20 m/s, which C1 was to prevent.
  const double radius = 7.5;
  world::Document d;
  const auto h = static_cast<float>(radius * 0.5522847);
  world::append_knot(d, test::skew_knot({3.3f, 5.5f, -7.7f}, {1, 0, 0}, h, h, world::JointKind::smooth));
  world::append_knot(d, test::skew_knot({23.3f, 5.5f, -7.7f}, {1, 0, 0}, h, h, world::JointKind::smooth));
  world::append_knot(d, test::skew_knot({30.8f, 13.0f, -7.7f}, {0, 1, 0}, h, h, world::JointKind::smooth));
  const DerivedTrack derived = test::derived_of(d);
  for (const world::Entity e : derived.order) {
    const Erratum step = *erratum(derived, e, 20, 64, "g_step");
    EXPECT_EQ(step.wrong, 0);
    // A quarter of a circle as one cubic bends a little less at its ends: (2/3) (1 - h) / h^2 of 1/R, 2.1 % off.
    const double at_end = 2.0 / 3.0 * (1 - 0.5522847) / (0.5522847 * 0.5522847);
    EXPECT_NEAR(step.right, at_end * 20.0 * 20.0 / radius / 9.81, 1e-4);
  }
}

TEST(errata, an_open_end_has_no_step_and_no_speed_makes_none) {
  const DerivedTrack derived = test::derived_of(test::straight_document({1.1f, 2.3f, 2.7f}, {31.1f, 2.3f, 7.7f}, 1));
  EXPECT_EQ(erratum(derived, derived.order[0], 30, 64, "g_step")->right, 0);
  const DerivedTrack bent = test::derived_of(test::sample_document());
  EXPECT_EQ(erratum(bent, bent.order[1], 0, 64, "g_step")->right, 0);
  EXPECT_GT(erratum(bent, bent.order[1], 9, 64, "g_step")->right, 0);
}

TEST(errata, a_segment_of_no_length_is_told_in_finite_numbers) {
  world::Document d;
  for (int i = 0; i < 2; ++i) world::append_knot(d, test::skew_knot({3.3f, 5.5f, -7.7f}, {0.3f, 1, 0}, 0.01f, 0.01f));
  const DerivedTrack derived = test::derived_of(d);
  for (const Erratum& e : errata(derived, derived.order[0], 33, 64))
    EXPECT_TRUE(std::isfinite(e.right) && std::isfinite(e.wrong)) << e.name;
}

}  // namespace errata_test
}  // namespace coaster::sim
