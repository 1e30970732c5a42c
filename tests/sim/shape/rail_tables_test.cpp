#include "sim/shape/rail_tables.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "sim/ride/ride.h"
#include "sim/tracks.h"

namespace coaster::sim {
namespace rail_tables_test {

world::Document hilly() { return test::ring_document(12, 40.3, 7.7); }

TEST(rail_tables, heights_and_slopes_are_those_of_the_curve) {
  const world::Document d = hilly();
  const DerivedTrack derived = test::derived_of(d);
  RailTables tables;
  tables.update(derived, 1.1);
  ASSERT_EQ(tables.size(), derived.order.size());
  EXPECT_EQ(tables.length(), derived.length);
  std::mt19937 bits(5);
  for (std::size_t i = 0; i < tables.size(); ++i)
    for (int n = 0; n < 100; ++n) {
      const double s = derived.shape(derived.order[i]).arc.length() * (bits() / 4294967296.0);
      const RailPoint exact = rail_point(derived.shape(derived.order[i]), s);
      const RailPoint table = rail_at(tables.segment(i), s);
      ASSERT_NEAR(table.height, exact.height, 1e-6) << i << " " << s;
      ASSERT_NEAR(table.slope, exact.slope, 1e-5) << i << " " << s;
      // The slope is the table's own derivative: energy is kept by it.
      const double h = 1e-5;
      ASSERT_NEAR((rail_at(tables.segment(i), s + h).height - rail_at(tables.segment(i), s - h).height) / (2 * h),
                  table.slope, 1e-4);
    }
}

TEST(rail_tables, rails_go_on_straight_beyond_their_ends) {
  const DerivedTrack derived = test::derived_of(test::sample_document());
  RailTables tables;
  tables.update(derived, 0);
  const SegmentTable& table = tables.segment(1);
  const double length = derived.shape(derived.order[1]).arc.length();
  EXPECT_NEAR(rail_at(table, -2).height, rail_at(table, 0).height - 2 * rail_at(table, 0).slope, 1e-12);
  EXPECT_NEAR(rail_at(table, length + 2).height, rail_at(table, length).height + 2 * rail_at(table, length).slope,
              1e-9);
  EXPECT_EQ(rail_at(table, length + 2).slope, rail_at(table, length + 5).slope);
}

// Compares with the ride's value for a cart on the exact curve, at the same position, speed and acceleration.
TEST(rail_tables, what_riders_feel_is_what_the_ride_says_on_the_exact_curve) {
  world::Document d = hilly();
  world::set_roll(d.entities.get<world::Knot>(d.track.knots[3]), 37);
  d.heartline = 1.1;
  const world::Entity cart = world::add_cart(d, d.track.segments[2], 0.0);
  d.start_speed = 17.3;
  const DerivedTrack derived = test::derived_of(d);
  RailTables tables;
  tables.update(derived, d.heartline);
  RideCache cache;
  world::Motion motion;
  reset(d, derived, motion);
  motion.state = world::RideState::running;
  std::size_t hint = 0;
  for (int n = 0; n < 400; ++n) {
    step(d, derived, {}, 3, cache, motion);
    const world::TrainMotion& at = motion.carts.get(cart);
    const FeltAcceleration exact = felt(d, derived, cart, at);
    const double s = tables.locate(at.track_distance, hint);
    const double a = -world::kGravity * rail_at(tables.segment(hint), s).slope;
    const glm::vec3 table = felt_at(tables.segment(hint), s, static_cast<float>(a / world::kGravity),
                                    static_cast<float>(at.speed * at.speed / world::kGravity));
    ASSERT_NEAR(table.z, exact.up, 2e-3) << n;
    ASSERT_NEAR(table.y, exact.left, 2e-3) << n;
    ASSERT_NEAR(table.x, exact.forward, 2e-3) << n;
  }
  EXPECT_GT(motion.carts.get(cart).travelled, derived.length / 2);
}

// Differences of the heartline itself, over 0.02 m: they err by 1e-4 /m in the bend.
TEST(rail_tables, entries_are_the_derivatives_of_the_heartline) {
  world::Document d = hilly();
  world::set_roll(d.entities.get<world::Knot>(d.track.knots[3]), 37);
  const DerivedTrack derived = test::derived_of(d);
  const double heartline = 1.1, step = 0.02;
  for (const std::size_t index : {std::size_t{1}, std::size_t{2}, std::size_t{3}}) {
    const SegmentShape& shape = derived.shape_at(index);
    const auto heart = [&](double s) {
      return curve::point(shape.key.cubic, shape.arc.parameter(s)) + heartline * frame_at(shape, s).up;
    };
    for (const double part : {0.003, 0.31, 0.5, 0.74, 0.997}) {
      const double s = part * shape.arc.length();
      const glm::dvec3 before = heart(s - step), here = heart(s), after = heart(s + step);
      const glm::dvec3 first = (after - before) / (2 * step), second = (after - 2.0 * here + before) / (step * step);
      const curve::Frame frame = frame_at(shape, s);
      const FeltEntry entry = felt_entry(shape, s, shape.arc.parameter(s), frame, heartline);
      const glm::dvec3 axes[] = {frame.forward, frame.left(), frame.up};
      for (int i = 0; i < 3; ++i) {
        EXPECT_NEAR(entry.along[i], glm::dot(first, axes[i]), 1e-5) << index << " " << part << " " << i;
        EXPECT_NEAR(entry.bend[i], glm::dot(second, axes[i]), 1e-4) << index << " " << part << " " << i;
        EXPECT_NEAR(entry.weight[i], axes[i].y, 1e-6) << index << " " << part << " " << i;
      }
    }
  }
}

// A straight that turns once about itself to the right at the even rate w: U' = -w L and U'' = -w^2 U everywhere, so
// the heartline's h' is (1, -d w, 0) and its h'' (0, 0, -d w^2) on the seat's axes, at both ends as in the middle.
TEST(rail_tables, the_heartline_of_a_twisted_straight_has_the_closed_form_up_to_the_ends) {
  world::Document d = test::straight_document({1.1f, 12.3f, 2.7f}, {13.1f, 12.3f, 2.7f});
  d.entities.get<world::Segment>(d.track.segments[0]).turns = 1;
  const double heartline = 1.1, w = 2 * M_PI / 12;
  for (const world::Entity e : d.track.knots) d.entities.get<world::Knot>(e).spin = static_cast<float>(w);
  const DerivedTrack derived = test::derived_of(d);
  RailTables tables;
  tables.update(derived, heartline);
  const std::vector<FeltEntry>& felt = tables.segment(0).felt;
  ASSERT_GT(felt.size(), 40u);
  for (const FeltEntry& entry : felt) {
    EXPECT_NEAR(entry.along.x, 1, 1e-5);
    EXPECT_NEAR(entry.along.y, -heartline * w, 1e-5);
    EXPECT_NEAR(entry.along.z, 0, 1e-5);
    EXPECT_NEAR(entry.bend.x, 0, 1e-5);
    EXPECT_NEAR(entry.bend.y, 0, 1e-5);
    EXPECT_NEAR(entry.bend.z, -heartline * w * w, 1e-5);
  }
}

TEST(rail_tables, an_edit_refills_its_two_segments_alone) {
  world::Document d = hilly();
  DerivedTrack derived;
  derive(d, {}, {}, derived);
  RailTables tables;
  tables.update(derived, 1.1);
  const std::uint64_t serial = tables.serial();
  tables.update(derived, 1.1);
  EXPECT_EQ(tables.serial(), serial);
  // Where the entries are: a refill of another size or of a new segment may move them.
  std::vector<const double*> before;
  std::vector<std::uint64_t> builds;
  for (std::size_t i = 0; i < tables.size(); ++i) builds.push_back(tables.segment(i).build);
  d.entities.get<world::Knot>(d.track.knots[5]).position.y += 1.3f;
  derive(d, {}, {}, derived);
  tables.update(derived, 1.1);
  EXPECT_GT(tables.serial(), serial);
  for (std::size_t i = 0; i < tables.size(); ++i)
    EXPECT_EQ(tables.segment(i).build != builds[i], i == 4 || i == 5) << i;
  for (std::size_t i = 0; i < tables.size(); ++i) builds[i] = tables.segment(i).build;
  tables.update(derived, 0.7);  // the heartline is in all of them
  for (std::size_t i = 0; i < tables.size(); ++i) EXPECT_EQ(tables.segment(i).heartline, 0.7) << i;
}

TEST(rail_tables, places_wrap_on_a_closed_track_and_stay_on_an_open_one) {
  const DerivedTrack derived = test::derived_of(hilly());
  RailTables tables;
  tables.update(derived, 0);
  for (const double d : {0.3, 17.7, derived.length - 0.1})
    for (const double rounds : {-2.0, 0.0, 3.0}) {
      std::size_t hint = 7, plain = 0;
      const double s = tables.locate(d + rounds * derived.length, hint), expected = tables.locate(d, plain);
      EXPECT_EQ(hint, plain);
      EXPECT_NEAR(s, expected, 1e-9);
      EXPECT_NEAR(tables.start(hint) + s, d, 1e-9);
    }
  const DerivedTrack open = test::derived_of(test::straight_document({1, 2, 3}, {31, 2, 3}, 3));
  RailTables straight;
  straight.update(open, 0);
  std::size_t hint = 1;
  EXPECT_LT(straight.locate(-2.0, hint), 0);
  EXPECT_EQ(hint, 0u);
  EXPECT_NEAR(straight.locate(33.0, hint), 13.0, 1e-5);
  EXPECT_EQ(hint, 2u);
}

// A straight of 5 km that turns sharply near one end: the bend has cells without gaps as far as the entries reach, and
// the straight has none.
TEST(rail_tables, a_long_segment_with_a_tight_bend_has_cells_only_there) {
  world::Document d;
  world::append_knot(d, test::skew_knot({0, 5, 0}, {1, 0, 0}, 4000, 4000));
  world::append_knot(d, test::skew_knot({5000, 5, 0}, {0, 0, 1}, 0.5f, 0.5f));
  const DerivedTrack derived = test::derived_of(d);
  RailTables tables;
  tables.update(derived, 1.1);
  const SegmentTable& table = tables.segment(0);
  ASSERT_FALSE(table.peaks.empty());
  ASSERT_FALSE(table.cells.empty());
  const double length = derived.length, peak = table.peaks.front();
  EXPECT_LE(table.cells.front().from, std::max(0.0, peak - table.step));
  EXPECT_GE(table.cells.back().to, std::min(length, peak + table.step));
  EXPECT_LT(table.cells.back().to - table.cells.front().from, 50);
  for (std::size_t i = 1; i < table.cells.size(); ++i) EXPECT_EQ(table.cells[i].from, table.cells[i - 1].to) << i;
}

}  // namespace rail_tables_test
}  // namespace coaster::sim
