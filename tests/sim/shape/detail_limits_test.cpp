// The memory of everything derived from very long tracks and tracks of very many segments.
#include "sim/shape/detail_limits.h"

#include <gtest/gtest.h>

#include "base/tries.h"
#include "sim/ride/simulated_ride.h"
#include "sim/solids/supports.h"
#include "sim/solids/track_mesh.h"
#include "sim/tracks.h"

namespace coaster::sim {
namespace detail_limits_test {

// Knots at the corners of the world, one after the other across it.
world::Document corners(int count) {
  world::Document d;
  for (int i = 0; i < count; ++i) {
    const int corner = i * 5 % 8;
    const glm::vec3 at(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1);
    world::append_knot(d, test::skew_knot(world::kMaxCoordinate * at, {1, 0, 0}, 1e4f, 1e4f));
  }
  return d;
}

std::size_t bytes_of_solids(const DerivedTrack& derived) {
  const SolidsDetail detail = detail_of(derived);
  std::size_t bytes = 0;
  Mesh mesh;
  for (std::size_t i = 0; i < derived.order.size(); ++i) {
    sweep_track(derived.shape_at(i), mesh, {}, detail);
    add_fittings(derived.shape_at(i), world::EquipmentKind::lift, mesh, detail);
    bytes += mesh.vertices.size() * sizeof(MeshVertex) + mesh.indices.size() * sizeof(mesh.indices[0]);
  }
  return bytes;
}

std::size_t bytes_of_tables(const RailTables& tables) {
  std::size_t bytes = 0;
  for (std::size_t i = 0; i < tables.size(); ++i)
    bytes += tables.segment(i).height.size() * (2 * sizeof(double) + sizeof(FeltEntry));
  return bytes;
}

TEST(detail, ordinary_tracks_have_all_of_it) {
  for (const world::Document& d : {test::sample_document(), test::ring_document(200, 900.0)}) {
    EXPECT_EQ(detail_of(test::derived_of(d)), SolidsDetail());
    EXPECT_EQ(detail_text(detail_of(test::derived_of(d))), "");
  }
}

TEST(detail, knots_at_the_corners_of_the_world_take_bounded_memory) {
  for (const int count : {5, 40}) {
    if (test::kSanitized && count > 5) continue;
    const world::Document d = corners(count);
    const DerivedTrack derived = test::derived_of(d);
    ASSERT_GT(derived.length, 2e5 * (count - 1));
    const SolidsDetail detail = detail_of(derived);
    EXPECT_FALSE(detail.parts);
    EXPECT_NE(detail_text(detail).find("near the eye"), std::string::npos);
    EXPECT_LT(bytes_of_solids(derived), 600u << 20);
    Supports supports;
    supports.update(derived);
    EXPECT_EQ(supports.count(), 0);
    RailTables tables;
    tables.update(derived, 1.1);
    EXPECT_LT(bytes_of_tables(tables), 150u << 20);
    EXPECT_LE(tables.segment(0).step, detail.table_step);
    const SimulatedRide simulated = simulate(tables, {}, d, {.front = 10, .speed = 50}, {});
    EXPECT_GT(simulated.samples.size(), 100u);
  }
}

TEST(detail, many_segments_share_the_rings) {
  DerivedTrack derived;
  derived.starts = {0, 1000};
  derived.length = 1000;
  int before = kMaxRings;
  for (const std::size_t segments : {1000u, 1001u, 5000u, 100'000u, 200'000u, 200'001u, 1'000'000u}) {
    derived.order.resize(segments);
    const SolidsDetail detail = detail_of(derived);
    EXPECT_LE(static_cast<std::size_t>(detail.most_rings) * segments, kMaxAllRings) << segments;
    EXPECT_LE(detail.most_rings, before) << segments;
    EXPECT_EQ(detail.most_rings == 0, segments > 200'000) << segments;
    EXPECT_EQ(detail.parts, detail.most_rings > 0) << segments;
    before = detail.most_rings;
  }
}

TEST(detail, supports_come_back_when_the_track_is_short_again) {
  const DerivedTrack shorter = test::derived_of(test::ring_document(12, 40.0)), longer = test::derived_of(corners(5));
  Supports fresh, changed;
  fresh.update(shorter);
  ASSERT_GT(fresh.count(), 0);
  changed.update(shorter);
  changed.update(longer);
  EXPECT_EQ(changed.count(), 0);
  EXPECT_TRUE(changed.order().empty());
  changed.update(shorter);
  EXPECT_EQ(changed.count(), fresh.count());
}

}  // namespace detail_limits_test
}  // namespace coaster::sim
