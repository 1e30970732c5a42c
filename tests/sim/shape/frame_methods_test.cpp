#include "sim/shape/frame_methods.h"

#include <gtest/gtest.h>

#include "sim/ride/ride.h"
#include "sim/tracks.h"

namespace coaster::sim {
namespace frame_methods_test {

using glm::dvec3;
using world::FrameMethod;

// The oracle: `up` carried along the track by the differential equation U' = -(U . T') T, in its own Runge-Kutta steps;
// at each segment boundary the rotation relative to the method's frame is compared.
dvec3 carried(const curve::Cubic& c, dvec3 up, int steps) {
  const auto rate = [&](double t, dvec3 u) {
    const dvec3 d = curve::derivative(c, t), dd = curve::second_derivative(c, t);
    const double speed = glm::length(d);
    const dvec3 tangent = d / speed, turning = (dd - tangent * glm::dot(dd, tangent)) / speed;
    return -glm::dot(u, turning) * tangent;
  };
  const double h = 1.0 / steps;
  for (int i = 0; i < steps; ++i) {
    const double t = i * h;
    const dvec3 a = rate(t, up), b = rate(t + h / 2, up + h / 2 * a), e = rate(t + h / 2, up + h / 2 * b),
                f = rate(t + h, up + h * e);
    up += h / 6 * (a + 2.0 * b + 2.0 * e + f);
  }
  return glm::normalize(up);
}

world::Document banked_ring(bool closed) {
  world::Document d = test::ring_document(9, 41.7, 8.3);
  for (std::size_t i = 0; i < d.track.knots.size(); ++i)
    world::set_roll(d.entities.get<world::Knot>(d.track.knots[i]), -71.0 + 23.0 * static_cast<double>(i));
  d.entities.get<world::Segment>(d.track.segments[4]).turns = 2;
  // Not symmetric: such a ring would close without a twist.
  d.entities.get<world::Knot>(d.track.knots[2]).position += glm::vec3(5.3f, 9.1f, 3.7f);
  world::set_tangent(d.entities.get<world::Knot>(d.track.knots[6]), {0.3f, 0.8f, -0.4f});
  if (!closed) world::set_closed(d, false);
  return d;
}

TEST(frame_methods, the_table_has_a_row_for_each_method_in_order) {
  const auto rows = frame_methods();
  ASSERT_EQ(rows.size(), 4u);
  EXPECT_EQ(rows[static_cast<std::size_t>(FrameMethod::knots)].name, "knots");
  EXPECT_EQ(rows[static_cast<std::size_t>(FrameMethod::rmf)].name, "rmf");
  EXPECT_EQ(rows[static_cast<std::size_t>(FrameMethod::frenet)].name, "frenet");
  EXPECT_EQ(rows[static_cast<std::size_t>(FrameMethod::world_up)].name, "world_up");
}

TEST(frame_methods, every_row_gives_a_right_handed_frame_along_the_tangent) {
  for (const bool closed : {true, false}) {
    const DerivedTrack derived = test::derived_of(banked_ring(closed));
    for (const FrameMethodRow& row : frame_methods())
      for (std::size_t i = 0; i < derived.order.size(); ++i)
        for (const double share : {0.0, 0.137, 0.5, 0.93, 1.0}) {
          const SegmentShape& shape = derived.shape(derived.order[i]);
          const double s = share * shape.arc.length();
          const TrackFrame f = row.frame(derived, i, s);
          EXPECT_NEAR(glm::length(f.frame.up), 1, 1e-9) << row.name;
          EXPECT_NEAR(glm::dot(f.frame.up, f.frame.forward), 0, 1e-9) << row.name;
          const dvec3 tangent = curve::unit_tangent(shape.key.cubic, shape.arc.parameter(s));
          EXPECT_LT(glm::length(f.frame.forward - tangent), 1e-6) << row.name << " " << i << " " << share;
        }
  }
}

TEST(frame_methods, rmf_on_an_open_track_solves_the_equation_of_least_turning) {
  const DerivedTrack derived = test::derived_of(banked_ring(false));
  EXPECT_EQ(loop_twist(derived), 0);
  dvec3 up = track_frame(derived, FrameMethod::rmf, 0, 0.0).frame.up;
  for (std::size_t i = 0; i < derived.order.size(); ++i) {
    const SegmentShape& shape = derived.shape(derived.order[i]);
    up = carried(shape.key.cubic, up, 400);
    // Double reflection in 32 steps of a segment, 4th order: some 1e-6 rad a segment here.
    EXPECT_LT(glm::length(up - track_frame(derived, FrameMethod::rmf, i, shape.arc.length()).frame.up), 3e-5) << i;
  }
}

TEST(frame_methods, rmf_closes_a_loop_by_spreading_the_twist_that_is_left_over) {
  const DerivedTrack derived = test::derived_of(banked_ring(true));
  const curve::Frame first = track_frame(derived, FrameMethod::rmf, 0, 0.0).frame;
  dvec3 up = first.up;
  for (const world::Entity e : derived.order) up = carried(derived.shape(e).key.cubic, up, 400);
  EXPECT_NEAR(loop_twist(derived), curve::signed_angle(up, first.up, first.forward), 3e-5);
  EXPECT_GT(std::abs(loop_twist(derived)), 0.01);
  const std::size_t last = derived.order.size() - 1;
  EXPECT_LT(glm::length(
                track_frame(derived, FrameMethod::rmf, last, derived.shape(derived.order[last]).arc.length()).frame.up -
                first.up),
            1e-6);
  // Half way round half of it is spread.
  const TrackPlace half = place_at(derived, derived.length / 2);
  const curve::Frame there = track_frame(derived, FrameMethod::rmf, half.index, half.s).frame;
  dvec3 to_half = first.up;
  for (std::size_t i = 0; i < half.index; ++i)
    to_half = carried(derived.shape(derived.order[i]).key.cubic, to_half, 400);
  const SegmentShape& shape = derived.shape(derived.order[half.index]);
  to_half = carried(curve::split(shape.key.cubic, shape.arc.parameter(half.s)).left, to_half, 400);
  EXPECT_NEAR(curve::signed_angle(to_half, there.up, there.forward), loop_twist(derived) / 2, 1e-4);
}

TEST(frame_methods, a_plane_loop_has_no_twist_left_over) {
  EXPECT_NEAR(loop_twist(test::derived_of(test::ring_document(12, 33.3, 0))), 0, 1e-9);
}

TEST(frame_methods, rolling_the_knots_does_not_turn_the_rmf) {
  world::Document d = banked_ring(true);
  const DerivedTrack before = test::derived_of(d);
  for (std::size_t i = 1; i < d.track.knots.size(); ++i)
    world::set_roll(d.entities.get<world::Knot>(d.track.knots[i]), 151.3);
  const DerivedTrack after = test::derived_of(d);
  EXPECT_NEAR(loop_twist(before), loop_twist(after), 1e-5);
  for (const double distance : {11.1, 97.7, 203.3}) {
    const TrackPlace p = place_at(before, distance);
    EXPECT_LT(glm::length(track_frame(before, FrameMethod::rmf, p.index, p.s).frame.up -
                          track_frame(after, FrameMethod::rmf, p.index, p.s).frame.up),
              1e-5);
    EXPECT_GT(glm::length(track_frame(before, FrameMethod::knots, p.index, p.s).frame.up -
                          track_frame(after, FrameMethod::knots, p.index, p.s).frame.up),
              0.1);
  }
}

TEST(frame_methods, world_up_is_level_to_the_left_and_marked_on_a_vertical) {
  const DerivedTrack derived = test::derived_of(banked_ring(true));
  const TrackFrame f = track_frame(derived, FrameMethod::world_up, 3, 4.4);
  EXPECT_TRUE(f.defined);
  EXPECT_NEAR(f.frame.left().y, 0, 1e-12);
  EXPECT_GT(f.frame.up.y, 0);
  const DerivedTrack vertical = test::derived_of(test::straight_document({3.3f, 1.1f, 7.7f}, {3.3f, 31.1f, 7.7f}, 2));
  const TrackFrame v = track_frame(vertical, FrameMethod::world_up, 1, 3.3);
  EXPECT_FALSE(v.defined);
  EXPECT_NEAR(glm::length(v.frame.up), 1, 1e-12);
}

TEST(frame_methods, frenet_keeps_the_last_normal_over_a_straight_and_says_so) {
  // A quarter circle to the left, then two straights: the normal at the bend's end continues, although the knots roll.
  world::Document d;
  const float h = 20.0f * 0.5522847f;
  world::append_knot(d, test::skew_knot({23.3f, 5.5f, -7.7f}, {1, 0, 0}, h, h));
  world::append_knot(d, test::skew_knot({43.3f, 5.5f, -27.7f}, {0, 0, -1}, h, 5));
  world::append_knot(d, test::skew_knot({43.3f, 5.5f, -47.7f}, {0, 0, -1}, 5, 5));
  world::append_knot(d, test::skew_knot({43.3f, 5.5f, -67.7f}, {0, 0, -1}, 5, 5));
  world::set_roll(d.entities.get<world::Knot>(d.track.knots[2]), 77.7);
  const DerivedTrack derived = test::derived_of(d);
  const TrackFrame on_bend = track_frame(derived, FrameMethod::frenet, 0, 11.1);
  EXPECT_TRUE(on_bend.defined);
  EXPECT_LT(glm::length(dvec3(on_bend.frame.up) -
                        glm::normalize(dvec3(23.3, 5.5, -27.7) -
                                       curve::point(derived.shape(derived.order[0]).key.cubic,
                                                    derived.shape(derived.order[0]).arc.parameter(11.1)))),
            0.02);
  for (const std::size_t i : {std::size_t{1}, std::size_t{2}})
    for (const double s : {0.3, 9.9, 19.1}) {
      const TrackFrame f = track_frame(derived, FrameMethod::frenet, i, s);
      EXPECT_FALSE(f.defined);
      EXPECT_LT(glm::length(f.frame.up - dvec3(-1, 0, 0)), 1e-5) << i << " " << s;
    }
  // Nothing curved before: the knots' frame.
  const DerivedTrack straight = test::derived_of(test::straight_document({1.1f, 2.2f, 3.3f}, {31.1f, 2.2f, 9.3f}, 3));
  const TrackFrame f = track_frame(straight, FrameMethod::frenet, 2, 1.0);
  EXPECT_FALSE(f.defined);
  EXPECT_EQ(f.frame.up, track_frame(straight, FrameMethod::knots, 2, 1.0).frame.up);
}

TEST(frame_methods, a_segments_place_is_found_from_a_wrong_guess_too) {
  const DerivedTrack derived = test::derived_of(banked_ring(true));
  for (std::size_t i = 0; i < derived.order.size(); ++i) {
    EXPECT_EQ(index_of_segment(derived, derived.order[i], derived.starts[i]), i);
    EXPECT_EQ(index_of_segment(derived, derived.order[i], 1e9), i);
  }
  EXPECT_EQ(index_of_segment(derived, world::kNone, 3.3), derived.order.size());
}

}  // namespace frame_methods_test
}  // namespace coaster::sim
