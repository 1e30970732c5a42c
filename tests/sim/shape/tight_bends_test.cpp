// Tight bends of the track.
#include "sim/shape/folds.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "base/files.h"
#include "exchange/formats.h"
#include "sim/shape/rail_tables.h"
#include "sim/tracks.h"

namespace coaster::sim {
namespace tight_bends_test {

// Three bends of cubics that double back about a given radius, joined by straights.
world::Document with_bends(std::initializer_list<double> radii) {
  world::Document d;
  double x = 0;
  for (const double radius : radii) {
    const double width = 20, a = width - std::sqrt(6 * width * radius / 2.25), handle = std::hypot(a, width);
    const auto add = [&](glm::vec3 place, glm::vec3 tangent, double out) {
      world::append_knot(d, test::skew_knot(place, tangent, static_cast<float>(handle), static_cast<float>(out)));
    };
    add({x, 10, 0}, {a, 0, width}, handle);
    add({x + width, 10, 0}, {a, 0, -width}, 30);
    x += 120;
  }
  return d;
}

TEST(TightBends, AreFoundInTrackOrder) {
  const DerivedTrack derived = test::derived_of(with_bends({0.019, 0.6, 0.3}));
  const std::vector<TightBend> bends = tight_bends_of(derived);
  ASSERT_EQ(bends.size(), 2u);
  EXPECT_NEAR(bends[0].radius, 0.019, 1e-4);
  EXPECT_NEAR(bends[1].radius, 0.3, 1e-3);
  EXPECT_NEAR(bends[0].at, derived.starts[0] + 0.5 * derived.shape_at(0).arc.length(), 1e-3);
  EXPECT_NEAR(bends[1].at, derived.starts[4] + 0.5 * derived.shape_at(4).arc.length(), 1e-3);
  EXPECT_NEAR(least_radius(derived), bends[0].radius, 1e-12);
  EXPECT_EQ(tight_text(bends).substr(0, 40), "2 tight bends: a radius of 0.019 m at 18");
  EXPECT_EQ(tight_text({}), "");
}

// A circle of 0.4 m, of 16 segments: bent too tightly all along, through every joint.
TEST(TightBends, ThatGoOnThroughJointsAreOne) {
  const DerivedTrack derived = test::derived_of(test::circle_document(0.4, {0, 10, 0}, {1, 0, 0}, 16));
  EXPECT_EQ(tight_bends_of(derived).size(), 1u);
  EXPECT_NEAR(least_radius(derived), 0.4, 1e-3);
}

TEST(TightBends, ReversalsCountEach) {
  world::Document d;
  world::append_knot(d, test::skew_knot({3, 4, 5}, {1, 0, 1}, 10, 10));
  world::append_knot(d, test::skew_knot({17, 4, 19}, {1, 0, 1}, 30, 10));
  const DerivedTrack derived = test::derived_of(d);
  const std::vector<TightBend> bends = tight_bends_of(derived);
  ASSERT_EQ(bends.size(), 2u);
  EXPECT_EQ(bends[0].radius, 0);
  EXPECT_EQ(bends[1].radius, 0);
  EXPECT_LT(bends[0].at, bends[1].at);
  EXPECT_EQ(tight_text(bends).substr(0, 38), "2 tight bends: the direction reverses ");
  EXPECT_EQ(least_radius(derived), 0);
}

TEST(TightBends, StraightsHaveNoRadius) {
  EXPECT_TRUE(std::isinf(least_radius(test::derived_of(test::straight_document({0, 5, 0}, {48, 5, 0}, 4)))));
  EXPECT_GT(least_radius(test::derived_of(test::straight_document({0, 5, 0}, {40, 9, 3}, 3))), 1e5);  // rounding
  EXPECT_TRUE(std::isinf(least_radius({})));
}

TEST(TightBends, ShippedTracksHaveNone) {
  base::Files files;
  int tracks = 0;
  for (const auto& entry : std::filesystem::directory_iterator(std::filesystem::path(COASTER_SOURCE_DIR) / "tracks")) {
    if (entry.path().extension() != ".json") continue;
    const auto track = exchange::load_track(files, entry.path());
    if (!track) continue;
    ++tracks;
    const DerivedTrack derived = shapes_of(track->document);
    EXPECT_TRUE(tight_bends_of(derived).empty()) << entry.path();
    EXPECT_GT(least_radius(derived), kTightRadius) << entry.path() << ": rides in cells";
  }
  EXPECT_GT(tracks, 3);
}

// A change looks at its own segments alone; 100,000 segments take well under 0.2 s.
TEST(TightBends, AreCachedBySegment) {
  world::Document d = test::ring_document(300, 400);
  DerivedTrack derived = test::derived_of(d);
  static int looked = 0;
  Folds kept([](const SegmentShape& shape) {
    ++looked;
    return tight_bends_of(shape);
  });
  EXPECT_TRUE(kept.update(derived).empty());
  EXPECT_EQ(looked, 300);
  (void)kept.update(derived);
  EXPECT_EQ(looked, 300);
  d.entities.get<world::Knot>(d.track.knots[7]).out_length = 90;
  derive(d, {}, {}, derived);
  EXPECT_FALSE(kept.update(derived).empty());
  EXPECT_EQ(looked, 301);
}

}  // namespace tight_bends_test
}  // namespace coaster::sim
