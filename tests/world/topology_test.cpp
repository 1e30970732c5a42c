#include "world/topology.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "curve/arc_length.h"
#include "world/sample_documents.h"

namespace coaster::world {
namespace topology_test {

const Train& cart(const Document& d, std::uint32_t number) {
  return d.entities.get<Train>(find(d, {EntityKind::cart, number}));
}

// m from the start of the track.
double place_of(const Document& d, const Train& c) {
  double start = 0;
  for (const Entity s : d.track.segments) {
    const double length = curve::arc_length(cubic_of(d, s));
    if (s == c.segment) return start + c.fraction * length;
    start += length;
  }
  return -1;
}

TEST(topology, a_split_keeps_the_shape) {
  for (const double t : {0.13, 0.5, 0.871}) {
    Document d = test::sample_document();
    const curve::Cubic whole = cubic_of(d, d.track.segments[1]);
    const SplitResult r = split_segment(d, d.track.segments[1], t, {0, 1, 0});
    ASSERT_TRUE(r.knot.valid());
    const curve::Cubic left = cubic_of(d, r.first), right = cubic_of(d, r.second);
    for (int i = 0; i <= 20; ++i) {
      const double u = i / 20.0;
      // Knots store direction and length: handles move by a few float roundings at coordinates of about 150
      // m.
      EXPECT_NEAR(glm::distance(curve::point(left, u), curve::point(whole, u * t)), 0, 1e-4);
      EXPECT_NEAR(glm::distance(curve::point(right, u), curve::point(whole, t + u * (1 - t))), 0, 1e-4);
    }
    EXPECT_EQ(left.p3, right.p0);
  }
}

TEST(topology, a_split_makes_aligned_joints_and_keeps_order_and_names) {
  Document d = test::sample_document();
  const SplitResult r = split_segment(d, d.track.segments[0], 0.4, {0, 1, 0});
  EXPECT_EQ(label_of(d, r.knot), "k6");
  EXPECT_EQ(label_of(d, r.first), "s1");
  EXPECT_EQ(label_of(d, r.second), "s5");
  EXPECT_EQ(d.track.knots[1], r.knot);
  EXPECT_EQ(d.track.segments[1], r.second);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(knot(d, d.track.knots[i]).joint, JointKind::aligned);
  EXPECT_EQ(broken_invariant(d), std::nullopt);
}

TEST(topology, carts_keep_their_place_under_a_split_and_its_removal) {
  for (const double t : {0.2, 0.7}) {
    Document d = test::sample_document();
    const double before = place_of(d, cart(d, 1)), other = place_of(d, cart(d, 2));
    const SplitResult r = split_segment(d, d.track.segments[1], t, {0, 1, 0});
    EXPECT_EQ(cart(d, 1).segment, t < 0.37 ? r.second : r.first);
    EXPECT_NEAR(place_of(d, cart(d, 1)), before, 1e-3);
    EXPECT_NEAR(place_of(d, cart(d, 2)), other, 1e-3);
    const double length = curve::arc_length(cubic_of(d, r.first)) + curve::arc_length(cubic_of(d, r.second));
    double start = 0;
    start = curve::arc_length(cubic_of(d, d.track.segments[0]));
    remove_knot(d, r.knot);
    EXPECT_EQ(cart(d, 1).segment, r.first);
    EXPECT_NEAR(cart(d, 1).fraction, (before - start) / length, 1e-4);
    EXPECT_EQ(broken_invariant(d), std::nullopt);
  }
}

TEST(topology, a_split_that_would_make_a_handle_too_short_changes_nothing) {
  Document d = test::sample_document();
  const Document before = d;
  EXPECT_FALSE(split_segment(d, d.track.segments[1], 0.0005, {0, 1, 0}).knot.valid());
  EXPECT_FALSE(split_segment(d, d.track.segments[1], 0.9999, {0, 1, 0}).knot.valid());
  EXPECT_TRUE(d == before);
}

TEST(topology, removing_an_end_takes_its_segment_and_carts) {
  Document d = test::sample_document();
  remove_knot(d, d.track.knots.back());
  EXPECT_EQ(d.track.segments.size(), 3u);
  EXPECT_EQ(find(d, {EntityKind::cart, 2}), kNone);
  EXPECT_EQ(broken_invariant(d), std::nullopt);
  remove_knot(d, d.track.knots.front());
  EXPECT_EQ(label_of(d, d.track.segments.front()), "s2");
  EXPECT_EQ(broken_invariant(d), std::nullopt);
}

TEST(topology, removing_the_first_knot_of_a_closed_track_lets_the_last_segment_survive) {
  Document d = test::sample_document();
  set_closed(d, true);
  const Entity closing = d.track.segments.back();
  remove_knot(d, d.track.knots.front());
  EXPECT_TRUE(d.track.closed);
  EXPECT_EQ(d.track.segments.back(), closing);
  EXPECT_EQ(segment(d, closing).to, d.track.knots.front());
  EXPECT_EQ(broken_invariant(d), std::nullopt);
}

TEST(topology, a_closed_track_shrinks_to_one_knot_and_then_to_none) {
  Document d = test::sample_document();
  set_closed(d, true);
  while (d.track.knots.size() > 2) {
    remove_knot(d, d.track.knots[1]);
    ASSERT_EQ(broken_invariant(d), std::nullopt);
  }
  EXPECT_TRUE(d.track.closed);
  remove_knot(d, d.track.knots[0]);
  EXPECT_FALSE(d.track.closed);
  EXPECT_EQ(d.track.knots.size(), 1u);
  EXPECT_EQ(d.entities.size(), 1u);
  remove_knot(d, d.track.knots[0]);
  EXPECT_EQ(d.entities.size(), 0u);
}

TEST(topology, numbers_are_never_used_again) {
  Document d = test::sample_document();
  remove_knot(d, d.track.knots.back());
  const Entity e = append_knot(d, test::skew_knot({1.7f, 2.9f, 3.1f}, {1, 0.2f, 0}, 3, 3));
  EXPECT_EQ(label_of(d, e), "k6");
  EXPECT_EQ(label_of(d, d.track.segments.back()), "s5");
}

TEST(topology, opening_moves_carts_of_the_closing_segment_to_the_start) {
  Document d = test::sample_document();
  set_closed(d, true);
  add_cart(d, d.track.segments.back(), 0.5);
  set_closed(d, false);
  EXPECT_EQ(cart(d, 3), (Train{d.track.segments.front(), 0.0}));
  EXPECT_EQ(broken_invariant(d), std::nullopt);
}

TEST(topology, closing_needs_two_knots) {
  Document d;
  set_closed(d, true);
  EXPECT_FALSE(d.track.closed);
  append_knot(d, Knot{});
  set_closed(d, true);
  EXPECT_FALSE(d.track.closed);
}

RC_GTEST_PROP(topology, any_sequence_keeps_every_invariant, ()) {
  Document d = test::random_document(*rc::gen::arbitrary<std::uint32_t>());
  const auto steps = *rc::gen::container<std::vector<std::pair<int, int>>>(
      rc::gen::pair(rc::gen::inRange(0, 8), rc::gen::inRange(0, 1000)));
  for (const auto& step : steps) {
    const int what = step.first, where = step.second;
    const auto pick = [&](const std::vector<Entity>& v) { return v[static_cast<std::size_t>(where) % v.size()]; };
    if (what == 0 && !d.track.closed) append_knot(d, test::skew_knot({where, 1.3f, 2.9f}, {1, 0.1f, 0.3f}, 2.1f, 2.3f));
    if (what == 1 && !d.track.knots.empty()) remove_knot(d, pick(d.track.knots));
    if (what == 2 && !d.track.segments.empty())
      split_segment(d, pick(d.track.segments), (where + 0.5) / 1000, {0, 1, 0.1f});
    if (what == 3) set_closed(d, !d.track.closed);
    if (what == 4 && !d.track.segments.empty()) add_cart(d, pick(d.track.segments), where / 1000.0);
    if (const std::size_t count = d.track.segments.size(); what == 5 && count > 0) {
      const std::size_t first = static_cast<std::size_t>(where) % count;
      make_section(d, first, 1 + static_cast<std::size_t>(where / 17) % (count - first), {"a title", {}, {}});
    }
    if (what == 6) reverse(d);
    if (what == 7) weld_ends(d);
    settle_joints(d);
    const auto broken = broken_invariant(d);
    RC_ASSERT(broken == std::nullopt);
  }
}

TEST(topology, a_removed_knot_leaves_the_turns_of_both_its_segments) {
  for (const auto& [first, second, both] : {std::tuple(2, -1, 1), {1, 3, 4}, {-2, -1, -3}}) {
    Document d = test::sample_document();
    d.entities.get<Segment>(d.track.segments[1]).turns = first;
    d.entities.get<Segment>(d.track.segments[2]).turns = second;
    remove_knot(d, d.track.knots[2]);
    ASSERT_EQ(d.track.segments.size(), 3u);
    EXPECT_EQ(segment(d, d.track.segments[1]).turns, both);
  }
}

}  // namespace topology_test
}  // namespace coaster::world
