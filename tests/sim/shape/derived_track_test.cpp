#include "sim/shape/derived_track.h"

#include <cstring>

#include <gtest/gtest.h>

#include "base/portable_math.h"
#include "curve/carried_frame.h"
#include "curve/frame_oracle.h"
#include "sim/tracks.h"
#include "world/evaluation_settings.h"

namespace coaster::sim {
namespace derived_track_test {

TEST(derived, only_what_changed_is_rebuilt) {
  for (const int count : {8, 5000}) {
    world::Document d = test::ring_document(count, 1.6 * count);
    world::Settings settings;
    settings.evaluation->steps = 5;
    DerivedTrack derived;
    derive(d, settings, {}, derived);
    EXPECT_EQ(derived.rebuilds, count);
    EXPECT_EQ(derived.vertices, 6 * count);
    derive(d, settings, {}, derived);
    EXPECT_EQ(derived.rebuilds, 0);
    EXPECT_EQ(derived.compared, 0u);
    const std::uint64_t last = derived.last_build;
    d.entities.get<world::Knot>(d.track.knots[3]).position.y += 0.7f;
    derive(d, settings, {}, derived);
    EXPECT_EQ(derived.rebuilds, 2);
    EXPECT_LE(derived.compared, 64u);
    for (std::size_t i = 0; i < derived.order.size(); ++i)
      EXPECT_EQ(derived.shape(derived.order[i]).shape_build > last, i == 2 || i == 3) << i;
    settings.evaluation->steps = 7;
    derive(d, settings, {}, derived);
    EXPECT_EQ(derived.rebuilds, count);
    EXPECT_EQ(derived.vertices, 8 * count);
    settings.evaluation->evaluator = curve::EvaluatorId{0};
    derive(d, settings, {}, derived);
    EXPECT_EQ(derived.rebuilds, count);
    settings.evaluation->arc_length = curve::ArcLengthId{1};
    derive(d, settings, {}, derived);
    EXPECT_EQ(derived.rebuilds, 0);
  }
}

TEST(derived, rolling_a_knot_rebuilds_the_shapes_at_it) {
  world::Document d = test::ring_document(8, 17.3);
  DerivedTrack derived = test::derived_of(d);
  world::set_roll(d.entities.get<world::Knot>(d.track.knots[5]), 33.3);
  derive(d, {}, {}, derived);
  EXPECT_EQ(derived.rebuilds, 2);
}

TEST(derived, removed_segments_leave_nothing_behind) {
  world::Document d = test::ring_document(8, 17.3);
  DerivedTrack derived = test::derived_of(d);
  world::remove_knot(d, d.track.knots[4]);
  derive(d, {}, {}, derived);
  EXPECT_EQ(derived.segments.size(), 7u);
  EXPECT_EQ(derived.order, d.track.segments);
  EXPECT_EQ(derived.starts.size(), 8u);
  EXPECT_NEAR(derived.length, world::exact_length(d), 1e-9);
  // In memory the last knot took the place of the removed one.
  d.entities.get<world::Knot>(d.track.knots.back()).position.y += 0.7f;
  derive(d, {}, {}, derived);
  EXPECT_EQ(derived.rebuilds, 2);
  EXPECT_NEAR(derived.length, world::exact_length(d), 1e-9);
}

TEST(derived, the_length_of_a_circle_is_two_pi_r) {
  const DerivedTrack derived = test::derived_of(test::circle_document(7.5, {3.3, 1.1, -2.7}, {0.6, 0, 0.8}));
  // Float control points: 64 of them, each within 1e-6 m.
  EXPECT_NEAR(derived.length, 2 * M_PI * 7.5, 1e-4);
}

TEST(derived, frames_at_the_ends_are_the_knots) {
  world::Document d = test::sample_document();
  const DerivedTrack derived = test::derived_of(d);
  for (const world::Entity e : derived.order) {
    const world::Segment& segment = world::segment(d, e);
    const SegmentShape& shape = derived.shape(e);
    const world::Knot &from = world::knot(d, segment.from), &to = world::knot(d, segment.to);
    const curve::Frame start = frame_at(shape, 0), end = frame_at(shape, shape.arc.length());
    // Handles are float: at 150 m from the origin and 5 m long they turn by up to 150 * 6e-8 / 5.
    EXPECT_LT(glm::length(start.forward - glm::dvec3(from.tangent)), 5e-6);
    EXPECT_LT(glm::length(start.up - glm::dvec3(from.up)), 5e-6);
    EXPECT_LT(glm::length(end.forward - glm::dvec3(to.tangent)), 5e-6);
    EXPECT_LT(glm::length(end.up - glm::dvec3(to.up)), 5e-6);
    EXPECT_LT(glm::length(frame_at(shape, 1e-7).up - start.up), 1e-5);
    EXPECT_LT(glm::length(frame_at(shape, shape.arc.length() - 1e-7).up - end.up), 1e-5);
  }
}

TEST(derived, frames_are_orthonormal_and_turn_without_jumps) {
  const DerivedTrack derived = test::derived_of(test::sample_document());
  for (const world::Entity e : derived.order) {
    const SegmentShape& shape = derived.shape(e);
    curve::Frame last = frame_at(shape, 0);
    for (int i = 0; i <= 400; ++i) {
      const double s = shape.arc.length() * i / 400;
      const curve::Frame frame = frame_at(shape, s);
      EXPECT_NEAR(glm::length(frame.forward), 1, 1e-12);
      EXPECT_NEAR(glm::length(frame.up), 1, 1e-9);
      EXPECT_NEAR(glm::dot(frame.up, frame.forward), 0, 1e-9);
      EXPECT_LT(glm::length(frame.up - last.up), 0.2);
      last = frame;
    }
  }
}

TEST(derived, on_a_straight_with_the_mean_spin_at_both_ends_roll_is_linear_in_length) {
  // Unequal handles: linear in the parameter would be something else.
  world::Document d;
  world::append_knot(d, test::skew_knot({1.3f, 5.1f, 2.7f}, {1, 0, 0}, 2, 2));
  world::append_knot(d, test::skew_knot({31.3f, 5.1f, 2.7f}, {1, 0, 0}, 15, 15));
  world::set_roll(d.entities.get<world::Knot>(d.track.knots[1]), 50);
  d.entities.get<world::Segment>(d.track.segments[0]).turns = 1;
  const double total = (360.0 + 50.0) * M_PI / 180;
  for (const world::Entity e : d.track.knots) d.entities.get<world::Knot>(e).spin = static_cast<float>(total / 30);
  const DerivedTrack derived = test::derived_of(d);
  const SegmentShape& shape = derived.shape(derived.order[0]);
  EXPECT_NEAR(shape.roll.twist, total, 1e-6);
  for (const double s : {3.1, 7.7, 14.9, 22.3, 29.9}) {
    const double a = total * s / 30;  // rolled about +X: up goes from +Y towards +Z
    const glm::dvec3 up = frame_at(shape, s).up;
    EXPECT_NEAR(up.y, std::cos(a), 2e-6) << s;
    EXPECT_NEAR(up.z, std::sin(a), 2e-6) << s;
  }
}

TEST(derived, a_planar_circle_keeps_its_frame_without_twist) {
  const DerivedTrack derived = test::derived_of(test::circle_document(7.5, {3.3, 1.1, -2.7}, {0.6, 0, 0.8}));
  for (const world::Entity e : derived.order) EXPECT_NEAR(derived.shape(e).roll.twist, 0, 1e-5);
}

// The shape of one cubic, whose knots' up is `up`.
SegmentShape shape_of(const curve::Cubic& cubic, glm::dvec3 up) {
  SegmentShape shape;
  shape.key.cubic = cubic;
  shape.key.up_from = shape.key.up_to = glm::vec3(up);
  shape.arc = curve::ArcLengthMap(cubic);
  build_frames(shape);
  return shape;
}

TEST(derived, frames_and_twist_of_tight_spatial_curves_are_exact_to_1e_5_degrees) {
  int tight = 0;
  for (const curve::Cubic& c : curve::near_cusps(60, 81)) {
    const curve::FrameOracle oracle(c);
    const glm::dvec3 start = curve::perpendicular(curve::unit_tangent(c, 0), {0.2, 1, 0.3});
    const SegmentShape shape = shape_of(c, start);
    glm::dvec3 up = curve::perpendicular(curve::unit_tangent(c, 0), glm::dvec3(shape.key.up_from));
    double last = 0;
    for (const double part : {0.21, 0.37, 0.5, 0.613, 0.77, 1.0}) {
      const double s = part * shape.arc.length(), t = part == 1 ? 1 : shape.arc.parameter(s);
      up = oracle.carried(up, last, t), last = t;
      const curve::Frame frame = frame_at(shape, s);
      ASSERT_LT(glm::length(curve::rotate(frame.up, frame.forward, -shape.roll.angle(s)) - up), curve::kFrameBound);
    }
    const curve::Frame end = shape.frame(kFrameIntervals);
    const double twist = curve::signed_angle(up, curve::perpendicular(end.forward, start), end.forward);
    ASSERT_NEAR(std::remainder(shape.roll.twist - twist, 2 * M_PI), 0, curve::kFrameBound + 1e-7);  // up is in float
    tight += shape.tight != 0;
  }
  EXPECT_GT(tight, 50);
}

TEST(derived, the_twist_of_a_known_near_cusp) {
  // -178.4745 degrees by DOP853, an explicit Runge-Kutta method of order 8, at a tolerance of 1e-12.
  const SegmentShape shape = shape_of(
      {{0, 30, 0}, {20.0000010f, 30.1000004f, 20.0000010f}, {0, 29.8999996f, 20.0000010f}, {20, 30, 0}}, {0, 1, 0});
  EXPECT_NEAR(base::degrees(shape.roll.twist), -178.4745, 0.01);
}

TEST(derived, gentle_track_has_the_bits_of_single_steps) {
  for (std::uint32_t seed = 0; seed < 12; ++seed) {
    const DerivedTrack derived =
        test::derived_of(seed == 0 ? test::sample_document() : test::ring_document(20, 60 + seed));
    for (const world::Entity e : derived.order) {
      const SegmentShape& shape = derived.shape(e);
      const curve::Cubic& c = shape.key.cubic;
      curve::Frame frame{curve::unit_tangent(c, 0),
                         curve::perpendicular(curve::unit_tangent(c, 0), glm::dvec3(shape.key.up_from))};
      if (seed == 0 && shape.tight != 0) continue;  // short handles
      ASSERT_EQ(shape.tight, 0u);
      for (int i = 1; i <= kFrameIntervals; ++i) {
        const double t = i / 32.0;
        frame = curve::transport(frame, curve::point(c, t - 1 / 32.0), curve::point(c, t), curve::unit_tangent(c, t));
        const double angle = i == kFrameIntervals ? shape.roll.twist : shape.roll.angle(shape.arc.distance(t));
        EXPECT_EQ(shape.frame(i).up, curve::rotate(frame.up, frame.forward, angle));
      }
    }
  }
}

TEST(derived, over_a_cusp_up_goes_on_and_there_is_no_twist) {
  const SegmentShape shape = shape_of({{0, 10, 0}, {20, 30, 0}, {0, 30, 0}, {20, 10, 0}}, {0.6, 0, 0.8});
  EXPECT_TRUE(has_cusp(shape));
  const double middle = shape.arc.distance(0.5);
  const curve::Frame before = frame_at(shape, middle - 1e-5), after = frame_at(shape, middle + 1e-5);
  EXPECT_LT(glm::length(before.forward + after.forward), 1e-2);
  const auto carried = [&](const curve::Frame& frame, double s) {
    return curve::rotate(frame.up, frame.forward, -shape.roll.angle(s));
  };
  EXPECT_LT(glm::length(carried(before, middle - 1e-5) - carried(after, middle + 1e-5)), 1e-2);
  for (int i = 1; i < kFrameIntervals; ++i) {
    const double s = shape.arc.distance(i / 32.0);
    EXPECT_LT(glm::length(frame_at(shape, s - 1e-9).up - shape.frame(i).up), i == 16 ? 2.1 : 1e-3) << i;
    EXPECT_LT(glm::length(frame_at(shape, s + 1e-9).up - shape.frame(i).up), 1e-3) << i;
  }
  EXPECT_FALSE(has_cusp(shape_of({{0, 10, 0}, {20, 30, 0.01f}, {0, 30, 0}, {20, 10, 0}}, {0, 0, 1})));
  EXPECT_FALSE(has_cusp(test::derived_of(test::sample_document())));
}

TEST(derived, places_wrap_on_closed_tracks_and_clamp_on_open_ones) {
  const DerivedTrack ring = test::derived_of(test::ring_document(8, 17.3));
  for (const double distance : {0.3, 3.7, 55.1, 99.9}) {
    const TrackPlace a = place_at(ring, distance), b = place_at(ring, distance - 3 * ring.length);
    EXPECT_NEAR(ring.starts[a.index] + a.s, distance, 1e-9);
    EXPECT_NEAR(ring.starts[b.index] + b.s, distance, 1e-9);
  }
  const DerivedTrack open = test::derived_of(test::straight_document({1, 2, 3}, {31, 2, 3}, 3));
  EXPECT_EQ(place_at(open, -5).index, 0u);
  EXPECT_EQ(place_at(open, -5).s, 0.0);
  EXPECT_EQ(place_at(open, 1e9).index, 2u);
  EXPECT_NEAR(place_at(open, 1e9).s, 10, 1e-5);
}

TEST(derived, the_clock_measures_evaluation_alone) {
  int calls = 0;
  DerivedTrack derived;
  derive(
      test::ring_document(8, 17.3), {}, [&] { return 0.25 * calls++; }, derived);
  EXPECT_EQ(calls, 16);  // before and after each segment's polyline
  EXPECT_DOUBLE_EQ(derived.evaluation_seconds, 8 * 0.25);
  EXPECT_EQ(derived.evaluated_vertices, 8 * 65);
}

TEST(derived, evaluators_on_the_gpu_leave_no_polylines_and_cost_no_rebuild) {
  world::Document d = test::ring_document(8, 17.3);
  world::Settings settings;
  settings.evaluation->steps = 7;
  DerivedTrack derived;
  derive(d, settings, {}, derived);
  const double length = derived.length, measured = derived.measured_length;
  std::uint64_t last = derived.last_build;
  for (std::size_t row = 0; row < curve::evaluators().size(); ++row) {
    if (curve::evaluators()[row].evaluated_by == curve::EvaluatedBy::processor) continue;
    settings.evaluation->evaluator = static_cast<curve::EvaluatorId>(row);
    for (const int steps : {7, 4096, 1}) {
      settings.evaluation->steps = steps;
      derive(d, settings, {}, derived);
      EXPECT_EQ(derived.evaluated_by, curve::evaluators()[row].evaluated_by);
      EXPECT_EQ(derived.steps, steps);
      EXPECT_EQ(derived.vertices, 8 * (steps + 1));
      EXPECT_EQ(derived.rebuilds, 0);
      EXPECT_EQ(derived.evaluated_vertices, 0);
      EXPECT_EQ(derived.last_build, last);
      EXPECT_EQ(derived.deviation, 0);
    }
    for (const world::Entity e : derived.order) EXPECT_TRUE(test::polyline_of(derived.shape(e)).empty());
  }
  EXPECT_EQ(derived.length, length);
  EXPECT_EQ(derived.measured_length, measured);
  d.entities.get<world::Knot>(d.track.knots[3]).position.y += 0.7f;
  derive(d, settings, {}, derived);
  EXPECT_EQ(derived.rebuilds, 2);
  EXPECT_EQ(derived.evaluated_vertices, 0);
  settings.evaluation->evaluator = curve::EvaluatorId{0};
  settings.evaluation->steps = 7;
  last = derived.last_build;
  derive(d, settings, {}, derived);
  EXPECT_EQ(derived.rebuilds, 8);
  EXPECT_GT(derived.deviation, 0);
  for (const world::Entity e : derived.order) {
    EXPECT_EQ(test::polyline_of(derived.shape(e)).size(), 8u);
    EXPECT_GT(derived.shape(e).polyline_build, last);
  }
}

bool same_bits(const DerivedTrack& a, const DerivedTrack& b) {
  const auto bits = []<class T>(const T& x, const T& y) { return std::memcmp(&x, &y, sizeof(T)) == 0; };
  bool same = a.starts == b.starts && a.twists == b.twists && bits(a.measured_length, b.measured_length) &&
              bits(a.deviation, b.deviation) && a.rebuilds == b.rebuilds && a.last_build == b.last_build;
  for (std::size_t i = 0; i < a.order.size(); ++i) {
    const SegmentShape &x = a.shape_at(i), &y = b.shape_at(i);
    same = same && bits(x.ups, y.ups) && bits(x.deviation, y.deviation) && x.shape_build == y.shape_build &&
           x.polyline_build == y.polyline_build && bits(x.measured_length, y.measured_length) &&
           bits(x.roll.twist, y.roll.twist);
    for (const double s : {0.1, 3.3, 8.8}) same = same && bits(x.arc.parameter(s), y.arc.parameter(s));
  }
  return same;
}

TEST(derived, any_number_of_threads_gives_the_same_bits) {
  world::Document d = test::ring_document(3001, 4700);
  for (const std::size_t i : {2u, 70u, 2999u}) world::set_roll(d.entities.get<world::Knot>(d.track.knots[i]), 20);
  const world::Settings settings;
  std::vector<DerivedTrack> all(4);
  const unsigned workers[] = {1, 2, 7, base::cores()};
  for (const bool again : {false, true}) {
    for (std::size_t i = 0; i < all.size(); ++i) {
      derive(d, settings, {}, all[i], workers[i]);
      EXPECT_EQ(all[i].rebuilds, again ? 2000 : 3001);
      EXPECT_TRUE(same_bits(all[0], all[i])) << workers[i];
    }
    for (std::size_t i = 0; i < 3000; i += 3) d.entities.get<world::Knot>(d.track.knots[i]).position.y += 0.37f;
  }
}

TEST(derived, deviation_is_that_of_the_vertex_farthest_from_the_exact_point) {
  for (std::size_t row = 0; row < curve::evaluators().size(); ++row)
    for (const std::uint32_t seed : {3u, 4u, 5u}) {
      if (curve::evaluators()[row].evaluated_by != curve::EvaluatedBy::processor) continue;
      world::Settings settings;
      settings.evaluation->evaluator = static_cast<curve::EvaluatorId>(row);
      settings.evaluation->steps = seed == 4 ? 1 : 97;
      const DerivedTrack derived = test::derived_of(test::random_document(seed), settings);
      for (const world::Entity e : derived.order) {
        const SegmentShape& shape = derived.shape(e);
        const std::vector<glm::vec3> points = test::polyline_of(shape);
        double worst = 0;
        for (std::size_t i = 0; i < points.size(); ++i) {
          const double t = static_cast<double>(i) / static_cast<double>(points.size() - 1);
          const glm::dvec3 d = glm::dvec3(points[i]) - curve::point_long_double(shape.key.cubic, t);
          worst = std::max(worst, glm::dot(d, d));
        }
        EXPECT_EQ(shape.deviation, std::sqrt(worst)) << row << ' ' << seed;
      }
    }
}

// What caches go by, instead of a look at every segment.
TEST(derived, tells_what_was_rebuilt_since_a_build) {
  world::Document d = test::ring_document(50, 90);
  DerivedTrack derived = test::derived_of(d);
  const auto since = [&](std::uint64_t build) {
    const auto changes = derived.changes_since(build);
    std::vector<std::size_t> indices;
    if (!changes) return std::vector<std::size_t>{999};
    for (const ShapeChange& change : *changes) indices.push_back(change.index);
    return indices;
  };
  EXPECT_EQ(since(0), std::vector<std::size_t>{999}) << "all of them";
  const std::uint64_t first = derived.last_build;
  EXPECT_TRUE(since(first).empty());
  d.entities.get<world::Knot>(d.track.knots[9]).position.y += 0.7f;
  derive(d, {}, {}, derived);
  const std::uint64_t second = derived.last_build;
  d.entities.get<world::Knot>(d.track.knots[0]).position.y += 0.7f;
  derive(d, {}, {}, derived);
  EXPECT_EQ(since(first), (std::vector<std::size_t>{8, 9, 0, 49}));
  EXPECT_EQ(since(second), (std::vector<std::size_t>{0, 49}));
  EXPECT_TRUE(since(derived.last_build).empty());
  world::remove_knot(d, d.track.knots[30]);
  derive(d, {}, {}, derived);
  EXPECT_EQ(since(second), std::vector<std::size_t>{999}) << "indices are others now";
  const std::uint64_t third = derived.last_build;
  EXPECT_TRUE(since(third).empty());
  // The list stays as short as the track, for any number of edits.
  for (int i = 0; i < 200; ++i) {
    d.entities.get<world::Knot>(d.track.knots[20]).position.y += 0.01f;
    derive(d, {}, {}, derived);
    EXPECT_EQ(derived.rebuilds, 2);
    EXPECT_LE(derived.made.changes.size(), derived.order.size() + 2);
  }
  EXPECT_EQ(since(third), std::vector<std::size_t>{999});
}

}  // namespace derived_track_test
}  // namespace coaster::sim
