#include <limits>

#include "curve/arc_length.h"
#include "edit/commands/commands_document.h"
#include "edit/session_fixture.h"
#include "world/evaluation_settings.h"

namespace coaster::edit {
namespace perform_track_test {

class ChangingTrack : public test::SessionTest {};
class EmptyTrack : public test::SessionTest {
 protected:
  EmptyTrack() : SessionTest(world::Document{}) {}
};

TEST_F(ChangingTrack, a_split_keeps_length_shape_and_frames) {
  const double length = session.derived.length;
  const auto whole = session.derived.shape(entity("s3"));  // it has a whole turn
  good("split @s3 at 0.37");
  EXPECT_NEAR(session.derived.length, length, 1e-3);
  EXPECT_EQ(session.settings.selected, entity("k6"));
  const auto &first = session.derived.shape(entity("s3")), &second = session.derived.shape(entity("s5"));
  EXPECT_NEAR(first.roll.twist + second.roll.twist, whole.roll.twist, 0.02);
  const double middle = first.arc.length();
  for (const double s : {0.21 * length / 4, 0.5 * middle, 0.9 * middle, middle + 0.2 * second.arc.length()}) {
    const curve::Frame before = sim::frame_at(whole, s),
                       after = s < middle ? sim::frame_at(first, s) : sim::frame_at(second, s - middle);
    // The frames are tables of 33 rows a segment: a few milliradians between two tables of the same curve.
    EXPECT_NEAR(glm::distance(before.up, after.up), 0, 0.02) << s;
  }
}

TEST_F(ChangingTrack, a_split_wants_a_place_inside) {
  refused("split @s1 at 0", "between 0 and 1");
  refused("split @s1 at 1", "between 0 and 1");
  refused(SplitSegment{{{world::EntityKind::segment, 1}}, std::numeric_limits<double>::quiet_NaN()}, "finite");
  refused("split @s1 at 0.0001", "handle would leave the limits of 0.01 to 10000 m");
  refused("split @s9 at 0.5", "there is no segment @s9");
}

TEST_F(ChangingTrack, add_curve_splits_the_longest_segment_in_the_middle) {
  world::Entity longest;
  double most = 0;
  for (const world::Entity e : session.document.track.segments)
    if (const double l = curve::arc_length(world::cubic_of(session.document, e)); l > most) most = l, longest = e;
  const auto place = *world::index_of(session.document.track.segments, longest);
  good("add_curve");
  const auto& order = session.document.track.segments;
  ASSERT_EQ(order.size(), 5u);
  EXPECT_EQ(order[place], longest);
  EXPECT_NEAR(curve::arc_length(world::cubic_of(session.document, order[place])), most / 2, 1e-3);
  EXPECT_NEAR(curve::arc_length(world::cubic_of(session.document, order[place + 1])), most / 2, 1e-3);
}

TEST_F(EmptyTrack, add_curve_makes_a_track_from_nothing) {
  good("add_curve");
  EXPECT_EQ(session.document.track.knots.size(), 1u);
  good("add_curve");
  ASSERT_EQ(session.document.track.segments.size(), 1u);
  EXPECT_FLOAT_EQ(glm::distance(knot(1).position, knot(2).position), 10.0f);
  good("add_curve");
  EXPECT_EQ(session.document.track.segments.size(), 2u);
}

TEST_F(EmptyTrack, the_first_segment_brings_a_cart) {
  good("append at 1.1 2.2 3.3");
  EXPECT_EQ(session.document.entities.pool<world::Train>().size(), 0u);
  good("append at 21.1 5.2 9.3");
  ASSERT_TRUE(entity("c1").valid());
  EXPECT_EQ(session.document.entities.get<world::Train>(entity("c1")), (world::Train{entity("s1"), 0.0}));
  EXPECT_EQ(session.motion.carts.size(), 1u);
  good("undo");
  EXPECT_EQ(session.motion.carts.size(), 0u);
}

TEST_F(ChangingTrack, append_needs_an_open_track) {
  good("append at 90.1 8.2 40.3");
  EXPECT_EQ(session.settings.selected, entity("k6"));
  good("closed on");
  refused("append at 1 2 3", "the track is closed");
  good("closed off");
  clamped("append at 1e9 2 3", "position.x");
  refused(AppendKnot{{1, 2, std::numeric_limits<float>::quiet_NaN()}}, "finite");
}

TEST_F(ChangingTrack, removing_what_is_selected_clears_the_selection) {
  good("select @k3");
  good("remove @k3");
  EXPECT_EQ(session.settings.selected, world::kNone);
  good("select @c2");
  good("remove @c2");
  EXPECT_EQ(session.settings.selected, world::kNone);
  good("select @s4");
  good("remove @k5");
  EXPECT_EQ(session.settings.selected, world::kNone);
  good("undo");
  refused("remove @k9", "there is no knot @k9");
  refused("remove @c9", "there is no cart @c9");
  refused("remove @s1", "expected a knot, found @s1");
}

TEST_F(ChangingTrack, closing_adds_the_segment_and_keeps_ends_shaped_by_hand) {
  for (const char* ends : {"spin @k1 to 0", "spin @k5 to 0"}) good(ends);
  const world::Knot first = knot(1), last = knot(5);
  good("closed on");
  EXPECT_TRUE(session.document.track.closed);
  EXPECT_EQ(session.derived.order.size(), 5u);
  EXPECT_EQ(knot(1), first);
  EXPECT_EQ(knot(5), last);
}

TEST_F(EmptyTrack, closing_needs_two_knots) {
  refused("closed on", "at least 2 knots");
  good("append at 1.1 2.2 3.3");
  refused("closed on", "at least 2 knots");
}

TEST_F(ChangingTrack, carts_are_added_within_their_segment) {
  good("add_cart @s2 at 0.25");
  EXPECT_EQ(session.document.entities.get<world::Train>(entity("c3")), (world::Train{entity("s2"), 0.25}));
  EXPECT_EQ(session.motion.carts.size(), 3u);
  refused("add_cart @s2 at 1.5", "expected a fraction of the length from 0 to 1, found 1.5");
  refused("add_cart @s2 at -1", "from 0 to 1, found -1");
  refused("add_cart @k2 at 0.5", "expected a segment");
}

TEST_F(ChangingTrack, trains_are_limited) {
  const world::Entity segment = entity("s2");
  while (session.document.entities.pool<world::Train>().size() + 1 < world::kMaxCarts)
    world::add_cart(session.document, segment, 0.5);
  good("add_cart @s2 at 0.5");
  refused("add_cart @s2 at 0.5", "at most 10000 trains");
  EXPECT_EQ(session.motion.carts.size(), world::kMaxCarts);
  const std::string text = exchange::print_track(session.document);
  EXPECT_TRUE(exchange::parse_track(text, "t"));
  world::add_cart(session.document, session.document.track.segments[0], 0.1);
  const auto over = exchange::parse_track(exchange::print_track(session.document), "t");
  EXPECT_NE(over.status().message.find("carts: more than the limit of 10000"), std::string::npos)
      << over.status().message;
}

TEST_F(ChangingTrack, commands_over_the_vertex_budget_are_refused_and_name_it) {
  good("resolution 399");
  good("vertex_budget 1600");  // 4 segments of 400 vertices
  for (const char* line : {"split @s1 at 0.5", "add_curve", "append at 1 2 3", "closed on", "resolution 400"})
    refused(line, "over the vertex budget of 1600");
  refused("vertex_budget 1599", "over the vertex budget of 1599");
  good("remove @k5");
  good("resolution 500");
  EXPECT_TRUE(apply("undo"));  // brings a segment back: the resolution gives way
  EXPECT_EQ(session.settings.evaluation->steps, 399);
  const auto& notices = session.notices.list;
  EXPECT_NE(notices[notices.size() - 2].text.find("limit"), std::string::npos);
  EXPECT_EQ(notices.back().text, "Undo: Deleted k5.");
  EXPECT_LE(session.derived.vertices, 1600);
}

TEST_F(ChangingTrack, a_knot_beyond_the_border_of_the_world_is_not_inserted) {
  world::Document document;
  world::append_knot(document, test::skew_knot({99'990, 5, 0}, {1, 0, 0}, 200, 200));
  world::append_knot(document, test::skew_knot({99'990, 5, 50}, {-1, 0, 0}, 200, 200));
  start_on(document);
  refused("split @s1 at 0.5", "world");
  refused("add_curve", "world");
}

}  // namespace perform_track_test
}  // namespace coaster::edit
