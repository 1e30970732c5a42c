#include "sim/ground/ground.h"

#include <algorithm>
#include <random>
#include <set>

#include <gtest/gtest.h>

#include "base/tries.h"
#include "sim/ground/plants.h"
#include "sim/ground/tunnel_mesh.h"
#include "sim/solids/coaster_form.h"
#include "sim/tracks.h"
#include "world/sections.h"

namespace coaster::sim {
namespace ground_test {

constexpr double kCell = world::kGroundCell;
const TrackRoom kRoom = track_room(form_of(world::CoasterKind::steel));

std::vector<world::Land> lands() {
  std::vector<world::Land> all;
  for (std::size_t i = 1; i < base::count_of<world::Land>(); ++i) all.push_back(static_cast<world::Land>(i));
  return all;
}
std::string land_name(const testing::TestParamInfo<world::Land>& info) {
  return std::string(base::name_of(info.param));
}

// A closed track of 16 smooth knots about the origin, 2 to 24 m high, 45 to 140 m out.
world::Document circuit(std::uint32_t seed) {
  std::mt19937 bits(seed);
  const auto uniform = [&](double low, double high) { return low + (high - low) * (bits() / 4294967296.0); };
  constexpr int kKnots = 16;
  std::vector<glm::vec3> places;
  for (int i = 0; i < kKnots; ++i) {
    const double a = 2 * M_PI * i / kKnots, r = uniform(45, 140);
    places.emplace_back(r * std::cos(a), uniform(2, 24), -r * std::sin(a));
  }
  world::Document d;
  for (int i = 0; i < kKnots; ++i) {
    const glm::vec3 chord = places[(i + 1) % kKnots] - places[(i + kKnots - 1) % kKnots];
    const float handle = glm::length(chord) / 6;
    world::append_knot(d, test::skew_knot(places[i], chord, handle, handle, world::JointKind::smooth));
  }
  world::set_closed(d, true);
  return d;
}

// A straight level track along x at a height, in spans of 20 m, in a park whose land is a flat ridge by strokes.
struct Ridge {
  world::Document document;
  DerivedTrack derived;
  Ground ground;

  // A ridge of `top` metres over -along..along in x, within 60 m in z; elsewhere 0.
  explicit Ridge(double top, double along, double height, world::Earthwork wish = {}) {
    for (int i = -5; i <= 5; ++i) {
      world::Knot knot;
      knot.position = {20.0f * static_cast<float>(i), static_cast<float>(height), 0};
      knot.tangent = {1, 0, 0}, knot.in_length = knot.out_length = 20.0f / 3;
      world::append_knot(document, knot);
    }
    document.park = world::usual_park(world::Land::meadow, 3);
    document.park.relief = 0, document.park.water = world::kNoWater;
    set([&](int x, int z) { return std::abs(x) * kCell <= along && std::abs(z) <= 30 ? top : 0.0; });
    if (wish != world::Earthwork{})
      for (const world::SectionRun& run : world::sections_of(document))
        document.entities.get<world::Section>(run.section).earthwork = wish;
    update();
  }
  // Sets all heights within 128 m of the origin.
  void set(auto&& height) {
    std::vector<std::pair<world::TilePlace, world::GroundTile>> tiles;
    for (std::int16_t z = -2; z < 2; ++z) {
      for (std::int16_t x = -2; x < 2; ++x) {
        world::GroundTile tile;
        for (int v = 0; v < world::GroundTile::kVertices; ++v) {
          const int i = x * 32 + v % 32, j = z * 32 + v / 32;
          tile.heights[static_cast<std::size_t>(v)] = static_cast<std::int16_t>(32 * height(i, j));
        }
        tiles.push_back({{x, z}, tile});
      }
    }
    document.park.tiles.put(tiles);
  }
  void update() {
    derive(document, {}, {}, derived);
    ground.update(document, derived, kRoom);
  }
};

TEST(Land, is_the_plane_without_a_park) {
  const Land land;
  EXPECT_TRUE(land.plain());
  for (const double x : {0.0, 17.3, -400.0, 1e9}) EXPECT_EQ(land.height(x, 2 * x), 0);
  Ground ground;
  EXPECT_EQ(ground.height(3, 4), 0);
  EXPECT_EQ(ground.water(), world::kNoWater);
}

class Lands : public testing::TestWithParam<world::Land> {};
INSTANTIATE_TEST_SUITE_P(all, Lands, testing::ValuesIn(lands()), land_name);

TEST_P(Lands, are_level_where_tracks_begin_and_high_and_low_elsewhere) {
  const Land land(world::usual_park(GetParam(), 7));
  for (const double x : {-24.0, 0.0, 24.0}) EXPECT_NEAR(land.height(x, 0.4 * x), 0, 1e-9);
  double low = 0, high = 0;
  for (int i = -60; i <= 60; ++i) {
    for (int j = -60; j <= 60; ++j) {
      const double h = land.height(6.0 * i, 6.0 * j);
      low = std::min(low, h), high = std::max(high, h);
    }
  }
  EXPECT_LT(low, -0.5);
  EXPECT_GT(high, GetParam() == world::Land::meadow ? 1 : 6);
  EXPECT_LT(high, 120);
}

// The heights enter warnings, supports and ratings, so a seed has one land. Steps between vertices stay climbable
// except on terraces.
TEST_P(Lands, follow_from_the_seed_and_scale_with_the_relief) {
  world::Park park = world::usual_park(GetParam(), 11);
  const Land land(park);
  park.seed = 12;
  const Land other(park);
  park.seed = 11, park.relief = 0;
  const Land flat(park);
  double differs = 0, highest = 0;
  for (int i = -300; i <= 300; i += 7) {
    const double x = 1.1 * i, z = 0.7 * i + 33;
    EXPECT_EQ(land.height(x, z), Land(world::usual_park(GetParam(), 11)).height(x, z));
    differs = std::max(differs, std::abs(land.height(x, z) - other.height(x, z)));
    highest = std::max(highest, flat.height(x, z));
  }
  EXPECT_GT(differs, 1);
  EXPECT_LT(highest, 1e-9) << "without relief only basins of water are left";
}

TEST_P(Lands, fall_to_the_plane_far_away) {
  const Land land(world::usual_park(GetParam(), 5));
  for (const double x : {6000.0, -7000.0, 1e6}) EXPECT_NEAR(land.height(x, -x / 3), 0, 1e-6);
}

// Within each triangle the surface is the plane through its corners.
TEST(Ground, is_the_triangles_between_the_vertices) {
  world::Document document;
  document.park = world::usual_park(world::Land::hills, 7);
  DerivedTrack derived;
  Ground ground;
  derive(document, {}, {}, derived);
  ground.update(document, derived, kRoom);
  ASSERT_EQ(ground.tiles_across(), Ground::kUsualTiles);
  std::mt19937 bits(5);
  const auto uniform = [&](double low, double high) { return low + (high - low) * (bits() / 4294967296.0); };
  for (int i = 0; i < 3000; ++i) {
    const double x = uniform(-380, 380), z = uniform(-380, 380);
    const int cx = static_cast<int>(std::floor(x / kCell)), cz = static_cast<int>(std::floor(z / kCell));
    const Land& land = ground.land();
    const double corners[] = {land.vertex({cx, cz}), land.vertex({cx + 1, cz}), land.vertex({cx, cz + 1}),
                              land.vertex({cx + 1, cz + 1})};
    const double h = ground.height(x, z);
    EXPECT_GE(h, *std::min_element(corners, corners + 4) - 1e-4);
    EXPECT_LE(h, *std::max_element(corners, corners + 4) + 1e-4);
    EXPECT_NEAR(ground.height(kCell * cx, kCell * cz), corners[0], 1e-5);
    // Continuous across the diagonal and the sides.
    EXPECT_NEAR(ground.height(x + 1e-7, z - 1e-7), h, 1e-4);
  }
}

TEST(Ground, is_met_by_rays_where_they_reach_it) {
  world::Document document;
  document.park = world::usual_park(world::Land::cliffs, 9);
  DerivedTrack derived;
  Ground ground;
  derive(document, {}, {}, derived);
  ground.update(document, derived, kRoom);
  std::mt19937 bits(6);
  const auto uniform = [&](double low, double high) { return low + (high - low) * (bits() / 4294967296.0); };
  int met = 0;
  for (int i = 0; i < 500; ++i) {
    const glm::dvec3 from(uniform(-300, 300), uniform(30, 140), uniform(-300, 300));
    const glm::dvec3 along = glm::normalize(glm::dvec3(uniform(-1, 1), uniform(-1, 0.1), uniform(-1, 1)));
    if (from.y < ground.height(from.x, from.z)) continue;
    const auto t = ground.meet(from, along, 400);
    double brute = -1;  // by steps of 5 cm
    for (double s = 0; s <= 400 && brute < 0; s += 0.05) {
      const glm::dvec3 p = from + s * along;
      if (p.y < ground.height(p.x, p.z)) brute = s;
    }
    if (brute < 0) {
      EXPECT_FALSE(t.has_value()) << i;
      continue;
    }
    ASSERT_TRUE(t.has_value()) << i;
    const glm::dvec3 p = from + *t * along;
    EXPECT_NEAR(p.y, ground.height(p.x, p.z), 2e-4);
    EXPECT_NEAR(*t, brute, 3.0) << i;  // thin edges may be passed over
    ++met;
  }
  EXPECT_GT(met, 100);
  EXPECT_FALSE(ground.meet({0, -50, 0}, {0, 1, 0}).has_value()) << "from below";
}

TEST(Ground, is_cut_open_below_low_track) {
  Ridge ridge(3, 60, 1);
  EXPECT_TRUE(ridge.ground.tunnels().empty());
  EXPECT_NEAR(ridge.ground.height(0, 0), 1 - TrackRoom{}.below, 0.7) << "no deeper than usual";
  for (int x = -50; x <= 50; x += 5) {
    EXPECT_LE(ridge.ground.height(x, 0), 1 - kRoom.below + 1e-3) << x;
    EXPECT_LE(ridge.ground.height(x, kRoom.beside + 1), 1 - kRoom.below + 0.3) << x;
    EXPECT_NEAR(ridge.ground.height(x, 30), 3, 1e-3) << "the ridge beside the cut stays";
  }
  // No side of a cut is a wall.
  for (int z = 0; z < 30; ++z) EXPECT_LT(std::abs(ridge.ground.height(0, z + 1) - ridge.ground.height(0, z)), 2.5) << z;
}

TEST(Ground, keeps_the_hill_over_a_tunnel) {
  Ridge ridge(14, 50, 2);
  ASSERT_EQ(ridge.ground.tunnels().size(), 1u);
  const Tunnel& tunnel = ridge.ground.tunnels().front();
  EXPECT_NEAR(tunnel.length, 100, 2 * kSampleSpacing + 2 * kCell);
  EXPECT_NEAR(tunnel.from, 50, 2 * kSampleSpacing + kCell);  // the track begins at x = -100
  EXPECT_NEAR(ridge.ground.height(0, 0), 14, 1e-3);
  EXPECT_NEAR(ridge.ground.height(10, 20), 14, 1e-3);
  ASSERT_EQ(ridge.ground.gates().size(), 2u);
  EXPECT_NEAR(ridge.ground.gates()[0].at.x, -51.2, kSampleSpacing + kCell);
  EXPECT_GT(ridge.ground.gates()[0].inwards.x, 0.99);
  EXPECT_LT(ridge.ground.gates()[1].inwards.x, -0.99);
  // In front of the portal the track is free.
  EXPECT_LE(ridge.ground.height(ridge.ground.gates()[0].at.x - 1, 0), 2 - kRoom.below + 0.7);
}

// The hill leans back from a portal, behind it and on both sides, and is whole some way off.
TEST(Ground, rises_behind_and_beside_a_portal) {
  Ridge ridge(24, 60, 2);
  ASSERT_EQ(ridge.ground.gates().size(), 2u);
  for (const TunnelGate& gate : ridge.ground.gates()) {
    const auto height = [&](double behind, double aside) {
      return ridge.ground.height(gate.at.x + behind * gate.inwards.x, aside);
    };
    EXPECT_LT(height(4, 0), 12);
    EXPECT_GT(height(12, 0), height(4, 0) + 4);
    EXPECT_LT(height(14, 0), 20);
    for (const double side : {-1.0, 1.0}) {
      EXPECT_GT(height(4, 16 * side), height(4, 0) + 3) << side;
      EXPECT_GT(height(14, 16 * side), 22) << side;
      EXPECT_NEAR(height(6, 34 * side), 24, 1e-3) << side;
    }
    EXPECT_NEAR(height(30, 0), 24, 1e-3);
  }
}

TEST(Ground, covers_every_tunnel_and_uncovers_every_other_track) {
  for (std::uint32_t seed = 0; seed < static_cast<std::uint32_t>(test::tries(20)); ++seed) {
    world::Document document = circuit(seed);
    document.park = world::usual_park(seed % 2 == 0 ? world::Land::hills : world::Land::cliffs, seed);
    DerivedTrack derived;
    Ground ground;
    derive(document, {}, {}, derived);
    ground.update(document, derived, kRoom);
    std::set<std::size_t> mouths;  // near gates both meet
    for (std::size_t i = 0; i < ground.samples().size(); ++i)
      for (const TunnelGate& gate : ground.gates())
        if (glm::distance(ground.samples()[i].at, gate.at) < 12) mouths.insert(i);
    for (std::size_t i = 0; i < ground.samples().size(); ++i) {
      const TrackSample& sample = ground.samples()[i];
      if (mouths.contains(i)) continue;
      const double h = ground.height(sample.at.x, sample.at.z);
      bool beside_other = false;  // open track crosses over a tunnel, or the other way
      for (const TrackSample& other : ground.samples())
        beside_other = beside_other ||
                       (other.tunnel != sample.tunnel &&
                        glm::distance(glm::dvec2(other.at.x, other.at.z), glm::dvec2(sample.at.x, sample.at.z)) < 14);
      if (beside_other) continue;
      if (sample.tunnel) EXPECT_GT(h, sample.at.y + kRoom.above) << seed << ' ' << i;
      else EXPECT_LT(h, sample.at.y - 0.6) << seed << ' ' << i;
    }
  }
}

TEST(Ground, returns_when_the_track_leaves) {
  Ridge ridge(14, 50, 2);
  const double before = ridge.ground.height(-53, 0);
  world::Document with = ridge.document;
  for (const world::Entity e : with.track.knots) ridge.document.entities.get<world::Knot>(e).position.z += 100;
  ridge.update();
  EXPECT_NEAR(ridge.ground.height(-48, 0), 14, 1e-3);
  ridge.document = with;
  ridge.update();
  EXPECT_EQ(ridge.ground.height(-53, 0), before);
}

// The history of edits does not show: only document and track count.
TEST(Ground, is_the_same_however_it_was_reached) {
  for (std::uint32_t seed = 0; seed < static_cast<std::uint32_t>(test::tries(8)); ++seed) {
    world::Document document = circuit(seed);
    document.park = world::usual_park(world::Land::hills, seed + 1);
    DerivedTrack derived;
    Ground moved;
    std::mt19937 bits(seed);
    for (int step = 0; step < 5; ++step) {
      const world::Entity e = document.track.knots[bits() % document.track.knots.size()];
      document.entities.get<world::Knot>(e).position += glm::vec3(3, -2.5f, 4);
      derive(document, {}, {}, derived);
      moved.update(document, derived, kRoom);
    }
    DerivedTrack anew;
    derive(document, {}, {}, anew);
    Ground fresh;
    fresh.update(document, anew, kRoom);
    ASSERT_EQ(moved.patches().size(), fresh.patches().size());
    for (std::size_t i = 0; i < fresh.patches().size(); ++i)
      ASSERT_EQ(moved.patches()[i].heights, fresh.patches()[i].heights) << seed << ' ' << i;
    Plants grown, planted;
    grown.update(moved), planted.update(fresh);
    EXPECT_EQ(grown.trees(), planted.trees());
  }
}

TEST(Ground, builds_only_patches_near_a_moved_knot) {
  world::Document document = circuit(4);
  document.park = world::usual_park(world::Land::hills, 7);
  DerivedTrack derived;
  Ground ground;
  derive(document, {}, {}, derived);
  ground.update(document, derived, kRoom);
  EXPECT_EQ(ground.rebuilds(), Ground::kUsualTiles * Ground::kUsualTiles);
  const std::uint64_t build = ground.build();
  ground.update(document, derived, kRoom);
  EXPECT_EQ(ground.rebuilds(), 0);
  EXPECT_EQ(ground.build(), build);
  document.entities.get<world::Knot>(document.track.knots[3]).position.y += 1;
  derive(document, {}, {}, derived);
  ground.update(document, derived, kRoom);
  EXPECT_GT(ground.rebuilds(), 0);
  EXPECT_LT(ground.rebuilds(), 20);
}

TEST(Ground, follows_the_wish_of_a_section) {
  EXPECT_TRUE(Ridge(14, 50, 2, world::Earthwork::cut).ground.tunnels().empty());
  EXPECT_LT(Ridge(14, 50, 2, world::Earthwork::cut).ground.height(0, 0), 0.1);
  EXPECT_NEAR(Ridge(14, 50, 2, world::Earthwork::none).ground.height(0, 0), 14, 1e-3);
  EXPECT_TRUE(Ridge(5.5, 50, 2).ground.tunnels().empty());
  EXPECT_EQ(Ridge(5.5, 50, 2, world::Earthwork::tunnel).ground.tunnels().size(), 1u);
}

TEST(TunnelMesh, lets_trains_through_and_hides_the_hill) {
  const Ridge ridge(14, 50, 2);
  const EarthMesh mesh = tunnel_mesh(ridge.ground);
  ASSERT_FALSE(mesh.indices.empty());
  ASSERT_EQ(mesh.indices.size() % 3, 0u);
  for (const EarthVertex& v : mesh.vertices) {
    EXPECT_NEAR(glm::length(v.normal), 1, 1e-4);
    // Nothing within what trains need about the rails, except the floor.
    const double from_axis = std::hypot(double{v.position.y} - 2 - kRoom.lift, double{v.position.z});
    EXPECT_TRUE(from_axis > kRoom.tube - 0.2 || double{v.position.y} <= 2 - kRoom.below + 0.01);
  }
  // The holes are at the two mouths, and nowhere else.
  int holes = 0;
  for (int z = -60; z < 60; ++z) {
    for (int x = -60; x < 60; ++x) {
      if (!is_open(ridge.ground, {x, z})) continue;
      ++holes;
      EXPECT_NEAR(std::abs(kCell * x + 1), 49, 9);
      EXPECT_LT(std::abs(kCell * z + 1), 4);
    }
  }
  EXPECT_GE(holes, 4);
  EXPECT_LE(holes, 40);
}

// A portal is a wall across the track, which faces those who come.
TEST(TunnelMesh, has_portals_across_the_track) {
  int skew = 0;
  for (std::uint32_t seed = 0; seed < 4; ++seed) {
    world::Document document = circuit(seed);
    for (const world::Entity knot : document.track.knots)
      document.entities.get<world::Knot>(knot).position.y -= 14;  // half of it within earth
    document.park = world::usual_park(world::Land::hills, seed);
    DerivedTrack derived;
    derive(document, {}, {}, derived);
    Ground ground;
    ground.update(document, derived, kRoom);
    const EarthMesh mesh = tunnel_mesh(ground);
    for (const TunnelGate& gate : ground.gates()) {
      const glm::dvec3 in(gate.inwards.x, 0, gate.inwards.y), across(gate.inwards.y, 0, -gate.inwards.x);
      double left = 0, right = 0, top = 0;
      for (const EarthVertex& v : mesh.vertices) {
        const glm::dvec3 from = glm::dvec3(v.position) - gate.at;
        if (glm::dot(glm::dvec3(v.normal), in) > -0.99 || std::abs(glm::dot(from, in)) > 3 || glm::length(from) > 15)
          continue;
        const double aside = glm::dot(from, across);
        left = std::max(left, aside), right = std::min(right, aside), top = std::max(top, from.y);
      }
      EXPECT_GT(left, kRoom.tube) << seed;
      EXPECT_LT(right, -kRoom.tube) << seed;
      EXPECT_GT(top, kRoom.lift + kRoom.tube) << seed;
      skew += std::abs(gate.inwards.y) > 0.3;
    }
  }
  EXPECT_GT(skew, 2);
}

// Clear of track, stations, water and steep slopes, whatever the seed.
TEST(Plants, keep_clear_and_stay_where_they_are) {
  for (std::uint32_t seed = 0; seed < static_cast<std::uint32_t>(test::tries(6)); ++seed) {
    world::Document document = circuit(seed);
    document.park = world::usual_park(world::Land::hills, seed);
    DerivedTrack derived;
    Ground ground;
    Plants plants;
    derive(document, {}, {}, derived);
    ground.update(document, derived, kRoom);
    plants.update(ground);
    EXPECT_GT(plants.trees(), 300);
    for (std::size_t i = 0; i < plants.patches(); ++i) {
      for (const Plant& plant : plants.of(i)) {
        EXPECT_NEAR(double{plant.foot.y}, ground.height(double{plant.foot.x}, double{plant.foot.z}), 1e-3);
        EXPECT_GT(double{plant.foot.y}, ground.water() + 0.5);
        for (const TrackSample& sample : ground.samples()) {
          const double d = std::hypot(sample.at.x - double{plant.foot.x}, sample.at.z - double{plant.foot.z});
          if (!sample.tunnel) ASSERT_GT(d, 3.4) << seed;
        }
      }
    }
    // One more curve elsewhere moves no tree that is 60 m away.
    std::vector<Plant> before, after;
    const world::Entity e = document.track.knots[2];
    const glm::vec3 place = document.entities.get<world::Knot>(e).position;
    const auto far_ones = [&](std::vector<Plant>& into) {
      for (std::size_t i = 0; i < plants.patches(); ++i)
        for (const Plant& plant : plants.of(i))
          if (glm::distance(plant.foot, place) > 120) into.push_back(plant);
    };
    far_ones(before);
    document.entities.get<world::Knot>(e).position.y += 1;
    derive(document, {}, {}, derived);
    ground.update(document, derived, kRoom);
    plants.update(ground);
    far_ones(after);
    ASSERT_EQ(before.size(), after.size());
    for (std::size_t i = 0; i < before.size(); ++i) EXPECT_EQ(before[i].foot, after[i].foot);
  }
}

TEST(Plants, are_more_where_woods_are_more_and_none_where_a_brush_cleared_them) {
  world::Document document;
  document.park = world::usual_park(world::Land::hills, 7);
  DerivedTrack derived;
  derive(document, {}, {}, derived);
  int before = -1;
  for (const double woods : {0.0, 0.3, 0.6, 1.0}) {
    document.park.woods = woods;
    Ground ground;
    Plants plants;
    ground.update(document, derived, kRoom);
    plants.update(ground);
    EXPECT_GT(plants.trees(), before);
    before = plants.trees();
  }
  world::GroundTile cleared;
  cleared.woods.fill(1);
  const std::pair<world::TilePlace, world::GroundTile> tile{{2, 2}, cleared};
  document.park.tiles.put({&tile, 1});
  Ground ground;
  Plants plants;
  ground.update(document, derived, kRoom);
  plants.update(ground);
  EXPECT_LT(plants.trees(), before);
  for (std::size_t i = 0; i < plants.patches(); ++i)
    for (const Plant& plant : plants.of(i))
      if (plant.foot.x > 128 && plant.foot.x < 192 && plant.foot.z > 128 && plant.foot.z < 192)
        EXPECT_EQ(plant.kind, PlantKind::rock);
}

TEST(Plants, leave_the_front_of_a_portal_free) {
  Ridge ridge(14, 50, 2);
  ridge.document.park.woods = 1;
  ridge.update();
  Plants plants;
  plants.update(ridge.ground);
  ASSERT_EQ(ridge.ground.gates().size(), 2u);
  int around = 0;
  for (std::size_t i = 0; i < plants.patches(); ++i) {
    for (const Plant& plant : plants.of(i)) {
      for (const TunnelGate& gate : ridge.ground.gates()) {
        const glm::dvec2 from(plant.foot.x - gate.at.x, plant.foot.z - gate.at.z);
        const double behind = glm::dot(from, gate.inwards);
        EXPECT_FALSE(behind > -14 && behind < 5 && glm::length(from) < 15) << plant.foot.x << ' ' << plant.foot.z;
        around += glm::length(from) < 40;
      }
    }
  }
  EXPECT_GT(around, 20);
}

// Woods of middling density have thickets and clearings, on level land, too.
TEST(Plants, grow_in_thickets_with_clearings_between) {
  world::Document document;
  document.park = world::usual_park(world::Land::meadow, 3);
  document.park.relief = 0, document.park.water = world::kNoWater, document.park.woods = 0.5;
  DerivedTrack derived;
  derive(document, {}, {}, derived);
  Ground ground;
  Plants plants;
  ground.update(document, derived, kRoom);
  plants.update(ground);
  constexpr int kPlots = 24;  // across, of 32 m
  std::vector<int> trees(kPlots * kPlots);
  for (std::size_t i = 0; i < plants.patches(); ++i)
    for (const Plant& plant : plants.of(i))
      if (plant.kind == PlantKind::broadleaf || plant.kind == PlantKind::conifer)
        ++trees[static_cast<std::size_t>(static_cast<int>(plant.foot.z / 32 + kPlots / 2) * kPlots +
                                         static_cast<int>(plant.foot.x / 32 + kPlots / 2))];
  std::ranges::sort(trees);
  const int sparse = trees[kPlots * kPlots / 8], usual = trees[kPlots * kPlots / 2],
            dense = trees[kPlots * kPlots * 7 / 8];
  EXPECT_GT(usual, 2);
  EXPECT_LT(3 * sparse, usual);
  EXPECT_GT(dense, 2 * usual - 2);
}

// Whichever way the tree lies, and whichever patch it grows on.
TEST(Plants, are_no_farther_than_each_tree) {
  world::Document document;
  document.park = world::usual_park(world::Land::hills, 7);
  DerivedTrack derived;
  derive(document, {}, {}, derived);
  Ground ground;
  Plants plants;
  ground.update(document, derived, kRoom);
  plants.update(ground);
  ASSERT_GT(plants.trees(), 1000);
  for (std::size_t i = 0; i < plants.patches(); i += 5) {
    for (const Plant& plant : plants.of(i)) {
      if (plant.kind != PlantKind::broadleaf && plant.kind != PlantKind::conifer) continue;
      const glm::dvec3 trunk = glm::dvec3(plant.foot) + glm::dvec3(0, double{plant.size}, 0);
      for (const glm::dvec3 way :
           {glm::dvec3(4, 0, 0), glm::dvec3(-4, 0, 0), glm::dvec3(0, 0, 4), glm::dvec3(0, 0, -4)})
        ASSERT_LE(plants.distance(trunk + way, 9), 4 - 0.3 + 1e-9) << trunk.x << ' ' << trunk.z;
    }
  }
}

}  // namespace ground_test
}  // namespace coaster::sim
