// Tests reversing, duplicating and closing track (edit/perform/track.cpp).
#include <cmath>

#include <gtest/gtest.h>

#include "edit/session_fixture.h"
#include "world/selection.h"
#include "world/topology.h"

namespace coaster::edit {
namespace perform_span_test {

using glm::dvec3;
using world::Entity;

dvec3 point_at(const Session& session, double distance) {
  const sim::TrackPlace place = sim::place_at(session.derived, distance);
  const sim::SegmentShape& shape = session.derived.shape(session.derived.order[place.index]);
  return curve::point(shape.key.cubic, shape.arc.parameter(place.s));
}

class Spans : public test::SessionTest {};

TEST_F(Spans, reversing_keeps_every_point_and_twice_is_nothing_but_the_carts_order) {
  const world::Document before = session.document;
  const double length = session.derived.length;
  std::vector<dvec3> points;
  for (int i = 0; i <= 20; ++i) points.push_back(point_at(session, length * i / 20));
  good("reverse");
  for (int i = 0; i <= 20; ++i)
    EXPECT_LT(glm::length(point_at(session, length * (20 - i) / 20) - points[static_cast<std::size_t>(i)]), 1e-4) << i;
  good("reverse");
  EXPECT_EQ(session.document.track, before.track);
  for (const Entity e : before.track.knots) EXPECT_EQ(world::knot(session.document, e), world::knot(before, e));
  for (const Entity e : before.track.segments)
    EXPECT_EQ(world::segment(session.document, e), world::segment(before, e));
}

TEST_F(Spans, reversing_keeps_the_twist_of_every_segment) {
  good("roll @k2 to 40");
  good("turns @" + world::label_of(session.document, session.document.track.segments[1]) + " to -1");
  std::vector<std::pair<Entity, double>> twists;
  for (const Entity e : session.derived.order) twists.emplace_back(e, session.derived.shape(e).roll.twist);
  good("reverse");
  for (const auto& [e, twist] : twists) EXPECT_NEAR(session.derived.shape(e).roll.twist, twist, 1e-4);
}

TEST_F(Spans, a_train_stands_on_the_same_rails_after_reversing) {
  const Entity cart = world::first_cart(session.document);
  const std::string name = "@" + world::label_of(session.document, cart);
  good("train " + name + " cars 3 spacing 2");
  const auto front = [&] {
    const world::Train& c = session.document.entities.get<world::Train>(cart);
    const std::size_t i = *world::index_of(session.derived.order, c.segment);
    return session.derived.starts[i] + c.fraction * (session.derived.starts[i + 1] - session.derived.starts[i]);
  };
  const double length = session.derived.length;
  const auto wrapped = [&](double d) {
    return session.derived.closed ? d - length * std::floor(d / length) : std::max(d, 0.0);
  };
  const dvec3 first = point_at(session, front()), last = point_at(session, wrapped(front() - 4));
  good("reverse");
  EXPECT_LT(glm::length(point_at(session, front()) - last), 1e-3);
  EXPECT_LT(glm::length(point_at(session, wrapped(front() - 4)) - first), 1e-3);
}

TEST_F(Spans, a_running_train_goes_on_the_same_way_through_space) {
  good("ride.start");
  advance(session, 60);
  const auto& cart = session.motion.carts.items()[0];
  const auto place = [&] {
    return point_at(session, session.derived.starts[*world::index_of(session.derived.order, cart.segment)] + cart.s);
  };
  const dvec3 before = place();
  const double speed = cart.speed;
  good("reverse");
  EXPECT_LT(glm::length(place() - before), 1e-3);
  EXPECT_NEAR(cart.speed, -speed, 1e-9);
  advance(session, 10);
  EXPECT_TRUE(std::isfinite(cart.s));
}

TEST_F(Spans, a_split_or_opened_track_keeps_its_trains_cars) {
  const Entity cart = world::first_cart(session.document);
  good("train @" + world::label_of(session.document, cart) + " cars 4 spacing 2.5 length 2 mass 800");
  const auto cars = [&] { return session.document.entities.get<world::Train>(cart).cars; };
  good("split @" + world::label_of(session.document, session.document.entities.get<world::Train>(cart).segment) +
       " at 0.5");
  EXPECT_EQ(cars(), 4);
  good("remove @" + world::label_of(session.document, session.settings.selected));
  EXPECT_EQ(cars(), 4);
  EXPECT_EQ(session.document.entities.get<world::Train>(cart).mass, 800.0f);
}

// A bent and rolled open track, k1 to k4.
world::Document bent() {
  world::Document document;
  const glm::vec3 places[] = {{0, 5, 0}, {10, 6, 3}, {16, 9, 12}, {14, 5, 24}};
  const glm::vec3 ways[] = {{1, 0, 0}, {1, 0.3f, 0.6f}, {0.2f, 0.1f, 1}, {-0.5f, -0.4f, 1}};
  for (int i = 0; i < 4; ++i) {
    world::Knot knot;
    knot.position = places[i];
    world::set_tangent(knot, ways[i]);
    world::set_roll(knot, 15.0 * i);
    knot.in_length = knot.out_length = 3.5f;
    world::append_knot(document, knot);
  }
  return document;
}

TEST_F(Spans, a_duplicate_is_the_same_shape_at_the_end) {
  start_on(bent());
  good("turns @s2 to 1");
  good("equip @s2 as lift speed 3");
  std::vector<double> lengths;
  for (const Entity e : session.derived.order) lengths.push_back(session.derived.shape(e).arc.length());
  good("duplicate @k2,@k3,@k4");
  ASSERT_EQ(session.document.track.knots.size(), 6u);
  EXPECT_NEAR(session.derived.shape(session.derived.order[3]).arc.length(), lengths[1], 1e-4);
  EXPECT_NEAR(session.derived.shape(session.derived.order[4]).arc.length(), lengths[2], 1e-4);
  EXPECT_NEAR(session.derived.shape(session.derived.order[3]).roll.twist,
              session.derived.shape(session.derived.order[1]).roll.twist, 1e-4);
  EXPECT_EQ(world::segment(session.document, session.document.track.segments[3]).turns, 1);
  EXPECT_TRUE(session.document.entities.find<world::Equipment>(session.document.track.segments[3]));
  EXPECT_FALSE(session.document.entities.find<world::Equipment>(session.document.track.segments[4]));
  EXPECT_EQ(world::selected_knots(session.document, session.settings).size(), 2u);
  // Curvature and torsion are those of the original: compare distances from the span's start, which a rigid motion
  // keeps.
  const double start = session.derived.starts[1], copy = session.derived.starts[3];
  for (int i = 1; i <= 10; ++i) {
    const double d = i * 0.1 * (lengths[1] + lengths[2]);
    EXPECT_NEAR(glm::length(point_at(session, start + d) - point_at(session, start)),
                glm::length(point_at(session, copy + d) - point_at(session, copy)), 1e-3);
  }
  refused("duplicate @k1,@k3", "neighbouring");
  good("closed on");
  refused("duplicate @k1,@k2", "closed");
}

TEST_F(Spans, closing_exactly_leaves_no_tiny_segment) {
  start_on(bent());
  good("append at 0.4 5.1 0.2");
  const double before = session.derived.length;
  good("close");
  EXPECT_TRUE(session.document.track.closed);
  EXPECT_EQ(session.document.track.knots.size(), 4u);
  EXPECT_EQ(session.document.track.segments.size(), 4u);
  EXPECT_NEAR(session.derived.length, before, 5.0);  // the end turns to the way the first knot has
  refused("close", "already");
}

TEST_F(Spans, ends_that_are_far_apart_get_a_segment_between) {
  start_on(bent());
  good("close");
  EXPECT_EQ(session.document.track.knots.size(), 4u);
  EXPECT_EQ(session.document.track.segments.size(), 4u);
  start_on({});
  refused("close", "at least 2");
  refused("reverse", "no track");
}

}  // namespace perform_span_test
}  // namespace coaster::edit
