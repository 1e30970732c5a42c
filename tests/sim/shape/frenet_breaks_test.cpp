// Failures of Frenet frames.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "sim/shape/frame_methods.h"
#include "sim/tracks.h"

namespace coaster::sim {
namespace frenet_breaks_test {

using Kind = FrenetBreak::Kind;

// Two knots: an S in a skew plane has its inflection in the middle.
world::Document s_bend() {
  world::Document d;
  world::append_knot(d, test::skew_knot({13.3f, 7.1f, -5.9f}, {0.6f, 0.7f, 0.2f}, 9, 9));
  world::append_knot(d, test::skew_knot({43.3f, 7.1f, -5.9f}, {0.6f, 0.7f, 0.2f}, 9, 9));
  return d;
}

TEST(frenet_breaks, an_inflection_is_one_flip_by_180_degrees_at_its_place) {
  const DerivedTrack derived = test::derived_of(s_bend());
  const auto found = frenet_breaks(derived);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].kind, Kind::flip);
  EXPECT_NEAR(found[0].t, 0.5, 1e-6);  // by symmetry
  EXPECT_NEAR(found[0].angle, M_PI, 1e-4);
  EXPECT_EQ(found[0].segment, derived.order[0]);
}

TEST(frenet_breaks, two_near_inflections_are_two_flips) {
  // B' = 60 (t - 1/2, (t - 1/2)^2 + d^2) inflects at 1/2 - d and 1/2 + d.
  for (const float d : {0.1f, 0.025f, 0.0125f, 0.00175f, 0.0005f}) {
    SegmentShape shape;
    const float e = 20 * d * d;
    shape.key.cubic = {{0, 0, 0}, {-10, 5 + e, 0}, {-10, 2 * e, 0}, {0, 5 + 3 * e, 0}};
    const auto found = frenet_breaks(shape, world::Entity{0, 0});
    ASSERT_EQ(std::count_if(found.begin(), found.end(), [](const FrenetBreak& at) { return at.kind == Kind::flip; }),
              2);
    EXPECT_NEAR(found.back().t - found.front().t, 2 * d, 0.1 * d);
  }
}

TEST(frenet_breaks, a_cusp_between_samples_is_undefined_once) {
  const glm::vec3 a(48, 96, 0), b(-96, 48, 0);
  for (const float u : {0.3f, 0.5f, 0.61f}) {
    SegmentShape shape;
    // B' = (t - u) (a + (t - u) b), rounded: only the one at 1/2 is surely a cusp.
    const glm::vec3 h0 = -u * a + u * u * b, h1 = h0 + 0.5f * (a - 2 * u * b), h2 = (1 - u) * (a + (1 - u) * b);
    shape.key.cubic = {{0, 0, 0}, h0 / 3.0f, (h0 + h1) / 3.0f, (h0 + h1 + h2) / 3.0f};
    shape.arc = curve::ArcLengthMap(shape.key.cubic);
    build_frames(shape);
    if (!has_cusp(shape)) continue;
    const auto found = frenet_breaks(shape, world::Entity{0, 0});
    ASSERT_EQ(found.size(), 1u) << u;
    EXPECT_EQ(found[0].kind, Kind::undefined);
    EXPECT_NEAR(found[0].t, u, 1e-6);
  }
  SegmentShape back;  // out and back on a line, turning at 1/2 -+ sqrt(1/20): without curvature from end to end
  back.key.cubic = {{0, 0, 0}, {8, 0, 0}, {-4, 0, 0}, {4, 0, 0}};
  EXPECT_EQ(frenet_breaks(back, world::Entity{0, 0}).size(), 1u);
}

TEST(frenet_breaks, agree_with_a_walk_along_random_segments) {
  // The oracle walks in 4096 steps and looks whether the normal has turned by more than 90 degrees within 1/32
  // anywhere.
  int flips = 0, none = 0;
  for (std::uint32_t seed = 1; seed < 60; ++seed) {
    const DerivedTrack derived = test::derived_of(test::random_document(seed));
    for (const world::Entity e : derived.order) {
      const curve::Cubic& c = derived.shape(e).key.cubic;
      const auto found = frenet_breaks(derived.shape(e), e);
      double sharpest = 1;
      for (int i = 32; i + 32 <= 2048; ++i) {
        const auto before = curve::frenet(c, (i - 32) / 2048.0), after = curve::frenet(c, (i + 32) / 2048.0);
        if (before && after) sharpest = std::min(sharpest, glm::dot(before->binormal, after->binormal));
      }
      const bool any = std::any_of(found.begin(), found.end(), [](const FrenetBreak& b) {
        return b.kind == Kind::flip && b.t > 1.0 / 64 && b.t < 63.0 / 64;
      });
      EXPECT_TRUE(!any || sharpest < 0.02) << seed;
      flips += any;
      none += sharpest > 0.05;
      EXPECT_TRUE(sharpest > -0.3 || any) << seed;
    }
  }
  EXPECT_GT(flips, 5);
  EXPECT_GT(none, 20);
}

TEST(frenet_breaks, straights_are_undefined_from_end_to_end) {
  const DerivedTrack derived =
      test::derived_of(test::straight_document({101.1f, 12.3f, 2.7f}, {163.1f, 31.3f, -7.7f}, 3));
  const auto found = frenet_breaks(derived);
  ASSERT_EQ(found.size(), 3u);
  for (const FrenetBreak& b : found) {
    EXPECT_EQ(b.kind, Kind::undefined);
    EXPECT_EQ(b.t, 0);
    EXPECT_EQ(b.t_end, 1);
  }
}

TEST(frenet_breaks, a_plane_ring_has_none_and_a_joint_between_left_and_right_has_one) {
  EXPECT_TRUE(frenet_breaks(test::derived_of(test::ring_document(16, 31.7, 0))).empty());
  world::Document d;
  const float h = 20.0f * 0.5522847f;
  world::append_knot(d, test::skew_knot({23.3f, 5.5f, -7.7f}, {1, 0, 0}, h, h));
  world::append_knot(d, test::skew_knot({43.3f, 5.5f, -27.7f}, {0, 0, -1}, h, h));
  world::append_knot(d, test::skew_knot({63.3f, 5.5f, -47.7f}, {1, 0, 0}, h, h));
  const DerivedTrack derived = test::derived_of(d);
  const auto found = frenet_breaks(derived);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].kind, Kind::flip);
  EXPECT_EQ(found[0].segment, derived.order[1]);
  EXPECT_EQ(found[0].t, 0);
  EXPECT_NEAR(found[0].angle, M_PI, 1e-5);
}

TEST(frenet_breaks, the_kept_list_is_the_fresh_one_after_every_edit) {
  FrenetBreaks kept;
  world::Document d = test::ring_document(11, 37.7, 9.1);
  DerivedTrack derived;
  std::mt19937 bits(5);
  for (int i = 0; i < 30; ++i) {
    if (i % 7 == 6) world::set_closed(d, !d.track.closed);
    world::Knot& knot = d.entities.get<world::Knot>(d.track.knots[bits() % d.track.knots.size()]);
    knot.position.y += static_cast<float>(bits() % 1000) / 71.0f - 7.0f;
    if (i == 12) world::remove_knot(d, d.track.knots[4]);
    derive(d, {}, {}, derived);
    const auto fresh = frenet_breaks(derived);
    const auto& now = kept.update(derived);
    ASSERT_EQ(now.size(), fresh.size()) << i;
    for (std::size_t k = 0; k < fresh.size(); ++k) {
      EXPECT_EQ(now[k].segment, fresh[k].segment);
      EXPECT_EQ(now[k].t, fresh[k].t);
      EXPECT_EQ(now[k].kind, fresh[k].kind);
    }
    EXPECT_EQ(&kept.update(derived), &now);
  }
}

TEST(frenet_breaks, degenerate_segments_are_told_and_bounded) {
  const glm::vec3 p(5.5f, -3.3f, 21.1f), q(9.7f, 4.4f, 18.3f);
  for (const curve::Cubic& c :
       {curve::Cubic{p, p, p, p}, curve::Cubic{p, p, q, q}, curve::Cubic{p, q, p, q}, curve::Cubic{p, q, q, p}}) {
    SegmentShape shape;
    shape.key.cubic = c;
    const auto found = frenet_breaks(shape, world::Entity{0, 0});
    EXPECT_FALSE(found.empty());
    EXPECT_LE(found.size(), 35u);
  }
}

}  // namespace frenet_breaks_test
}  // namespace coaster::sim
