// Figures of each section of the track: length, heights, and of a ride the speeds and g: src/sim/study/riders.
#include "sim/study/riders.h"

#include <gtest/gtest.h>

#include "sim/tracks.h"
#include "world/topology.h"

namespace coaster::sim {
namespace section_figures_test {

constexpr double kG = world::kGravity;

// A ride of one car, from that fraction of the first segment.
struct RiddenTrain {
  world::Document document;
  DerivedTrack derived;
  RideCache cache;
  Riders riders;
  std::vector<SectionFigures> rows;
  const SimulatedRide* simulated = nullptr;

  RiddenTrain(world::Document d, double fraction, double speed) : document(std::move(d)) {
    const world::Entity cart = world::add_cart(document, document.track.segments.at(0), fraction);
    document.start_speed = speed;
    derive(document, {}, {}, derived);
    simulated = cache.ride(document, derived, cart);
    riders.update(*simulated, cache.tables(document, derived), derived, 5, {0, 0});
    rows = section_figures(document, derived, riders.all());
  }
  double height(double distance) const {
    const TrackPlace at = place_at(derived, distance);
    const SegmentShape& shape = derived.shape_at(at.index);
    return curve::point(shape.key.cubic, shape.arc.parameter(at.s)).y;
  }
};

TEST(section_figures, lengths_and_heights_are_those_of_a_straight_slope) {
  world::Document d = test::straight_document({3, 20, -5}, {63, 4, 7}, 4);
  world::make_section(d, 0, 1, {});
  world::make_section(d, 1, 2, {});
  const DerivedTrack derived = test::derived_of(d);
  const std::vector<SectionFigures> rows = section_figures(d, derived, {});
  ASSERT_EQ(rows.size(), 3u);
  const double whole = glm::distance(glm::dvec3(3, 20, -5), glm::dvec3(63, 4, 7));
  const double quarters[] = {0, 1, 3, 4};
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(rows[i].length, whole * (quarters[i + 1] - quarters[i]) / 4, 1e-4);
    EXPECT_NEAR(rows[i].start, 20 - 4 * quarters[i], 1e-5);
    EXPECT_NEAR(rows[i].end, 20 - 4 * quarters[i + 1], 1e-5);
    EXPECT_EQ(rows[i].top, rows[i].start);
    EXPECT_FALSE(rows[i].speed_in || rows[i].speed_out || rows[i].g_most);
  }
}

// Without losses the speed follows from the height alone.
TEST(section_figures, speeds_at_both_ends_follow_from_the_heights) {
  world::Document d = test::straight_document({0, 30, 0}, {40, 10, 0}, 4);
  world::make_section(d, 0, 2, {});
  const RiddenTrain ride(std::move(d), 0.5, 6);
  ASSERT_EQ(ride.rows.size(), 2u);
  const double start = ride.height(ride.simulated->start.front);
  const auto speed = [&](double height) { return std::sqrt(36 + 2 * kG * (start - height)); };
  EXPECT_FALSE(ride.rows[0].speed_in) << "the train starts behind it";
  EXPECT_NEAR(ride.rows[0].speed_out.value(), speed(20), 1e-6);
  EXPECT_NEAR(ride.rows[1].speed_in.value(), speed(20), 1e-6);
  const double slope = 40 / std::hypot(40, 20);
  for (const SectionFigures& row : ride.rows) {
    EXPECT_NEAR(row.g_most.value(), slope, 2e-3) << "the rails push across the slope alone";
    EXPECT_NEAR(row.g_least.value(), slope, 2e-3);
    EXPECT_NEAR(row.g_side.value(), 0, 2e-3);
  }
}

// A ring: sections go over the joint, and the train starts in the middle of the first.
TEST(section_figures, a_closed_track_has_all_figures_of_the_lap) {
  world::Document d = test::ring_document(16, 40);
  world::make_section(d, 0, 3, {});
  world::make_section(d, 3, 6, {});
  const RiddenTrain ride(std::move(d), 0.7, 15);
  ASSERT_TRUE(ride.simulated->lap);
  ASSERT_EQ(ride.rows.size(), 3u);
  const double start = ride.height(ride.simulated->start.front);
  for (const SectionFigures& row : ride.rows) {
    const double in = ride.derived.starts[row.run.first], out = ride.derived.starts[row.run.end()];
    EXPECT_NEAR(row.speed_in.value(), std::sqrt(225 + 2 * kG * (start - ride.height(in))), 1e-6);
    EXPECT_NEAR(row.speed_out.value(), std::sqrt(225 + 2 * kG * (start - ride.height(out))), 1e-6);
    // By brute force over the ride's own samples.
    double most = -1e9, least = 1e9, side = 0;
    for (std::size_t k = 0; k < ride.simulated->forces.size(); ++k) {
      const double at = ride.simulated->distance(ride.simulated->sample_of(k));
      if (at < in || at > out) continue;
      const FeltAcceleration& f = ride.simulated->forces[k];
      most = std::max(most, double{f.up}), least = std::min(least, double{f.up});
      side = std::max(side, std::abs(double{f.left}));
    }
    constexpr double kEnds = 0.04;  // g, between the last sample and an end of the section
    EXPECT_NEAR(row.g_most.value(), most, kEnds);
    EXPECT_NEAR(row.g_least.value(), least, kEnds);
    EXPECT_NEAR(row.g_side.value(), side, kEnds);
    EXPECT_GE(row.g_most.value(), most) << "the ends count, too";
    double top = -1e9;
    for (int i = 0; i <= 2000; ++i) top = std::max(top, ride.height(in + (out - in) * i / 2000.0 * 0.999999));
    EXPECT_NEAR(row.top, top, 1e-4);
    EXPECT_GE(row.top, top - 1e-9);
  }
}

}  // namespace section_figures_test
}  // namespace coaster::sim
