#include "sim/ground/land_mesh.h"

#include <algorithm>
#include <random>

#include <gtest/gtest.h>

#include "sim/ground/fixtures.h"
#include "sim/ground/lamps.h"
#include "sim/ground/land_paint.h"
#include "sim/lands.h"
#include "sim/solids/coaster_form.h"
#include "sim/tracks.h"

namespace coaster::sim {
namespace land_mesh_test {

const glm::vec3 kSun = glm::normalize(glm::vec3(0.4216f, 0.7792f, 0.4638f));
const glm::vec3 kLowSun = glm::normalize(glm::vec3(-0.800f, 0.215f, -0.560f));

// A ring of track in the hills, through some of them, with what is derived from it.
struct Site {
  world::Document document = test::ring_document(12, 95, 9);
  world::Settings settings;
  DerivedTrack derived;
  Ground ground;
  Plants plants;

  explicit Site(world::Land land = world::Land::hills) {
    document.park = world::usual_park(land, 7);
    update();
  }
  void update() {
    world::settle_joints(document);
    derive(document, settings, {}, derived);
    ground.update(document, derived, track_room(form_of(document.kind)));
    plants.update(ground);
  }
  void move(std::size_t knot, glm::vec3 by) {
    document.entities.get<world::Knot>(document.track.knots[knot]).position += by;
    update();
  }
  LandMesh mesh(glm::vec3 sun = kSun) const {
    LandMesh made;
    made.update(ground, &plants, sun, true, {});
    return made;
  }
};

int differing(const LandMesh& a, const LandMesh& b) {
  int count = 0;
  for (std::size_t i = 0; i < a.patches().size(); ++i) {
    count += a.vertices(i) != b.vertices(i) || a.patches()[i].light != b.patches()[i].light ||
             a.triangles(i) != b.triangles(i);
  }
  return count;
}

TEST(LandMesh, is_the_ground) {
  const Site site;
  const LandMesh mesh = site.mesh();
  std::mt19937 bits(3);
  const auto uniform = [&] { return bits() / 4294967296.0; };
  ASSERT_EQ(mesh.patches().size(), site.ground.patches().size());
  for (std::size_t patch = 0; patch < mesh.patches().size(); ++patch) {
    const std::vector<std::uint16_t> indices = mesh.triangles(patch);
    for (int i = 0; i < 20 && !indices.empty(); ++i) {
      const std::size_t triangle = 3 * (bits() % (indices.size() / 3));
      const auto corner = [&](std::size_t k) { return mesh.place(patch, indices[triangle + k]); };
      const double u = uniform(), v = uniform() * (1 - u);
      const glm::dvec3 a(corner(0)), b(corner(1)), c(corner(2)), at = a + u * (b - a) + v * (c - a);
      ASSERT_NEAR(at.y, site.ground.height(at.x, at.z), 1e-3) << at.x << " " << at.z;
      ASSERT_GT(glm::cross(b - a, c - a).y, 0) << "counter-clockwise from above";
    }
    // What is drawn takes the heights of its patch of the ground.
    const GroundPatch& ground = site.ground.patches()[patch];
    for (std::size_t i = 0; i < ground.heights.size(); ++i) {
      const glm::vec3 at = mesh.place(patch, i);
      const auto x = static_cast<float>(2 * (i % GroundPatch::kSide)),
                 z = static_cast<float>(2 * (i / GroundPatch::kSide));
      ASSERT_EQ(at, glm::vec3(ground.corner().x + x, ground.heights[i], ground.corner().y + z)) << patch << " " << i;
    }
  }
}

TEST(LandMesh, leaves_out_what_is_open_and_nothing_else) {
  Site site;
  std::vector<std::pair<world::TilePlace, world::GroundTile>> block;  // a hill of 30 m over half of the ring
  for (std::int16_t x = 0; x < 3; ++x)
    for (std::int16_t z = -3; z < 3; ++z) {
      world::GroundTile tile;
      tile.heights.fill(30 * 32);
      block.emplace_back(world::TilePlace{x, z}, tile);
    }
  site.document.park.tiles.put(block);
  for (std::size_t knot = 0; knot < 12; ++knot) site.move(knot, {0, -6, 0});
  int open = 0;
  const LandMesh mesh = site.mesh();
  for (std::size_t i = 0; i < mesh.patches().size(); ++i) {
    const std::size_t cells = world::kGroundTileCells * world::kGroundTileCells, left = mesh.triangles(i).size() / 6;
    EXPECT_EQ(mesh.patches()[i].open.size(), cells - left);
    open += static_cast<int>(cells - left);
  }
  ASSERT_FALSE(site.ground.gates().empty()) << "the ring passes through the hill";
  EXPECT_GT(open, 0);
  EXPECT_LT(open, 24 * static_cast<int>(site.ground.gates().size()));
}

TEST(LandMesh, builds_nothing_twice_and_after_a_move_only_near_it) {
  Site site;
  LandMesh mesh = site.mesh();
  const auto builds = [&] {
    std::vector<std::uint64_t> all;
    for (const LandPatch& patch : mesh.patches()) all.push_back(patch.build);
    return all;
  };
  const auto before = builds();
  mesh.update(site.ground, &site.plants, kSun, true, {});
  EXPECT_EQ(builds(), before);
  for (std::size_t knot = 0; knot < 12; knot += 3) {
    const auto held = builds();
    site.move(knot, {1, -1.5f, 0.5f});
    mesh.update(site.ground, &site.plants, kSun, true, {});
    const auto now = builds();
    int built = 0;
    for (std::size_t i = 0; i < now.size(); ++i) built += now[i] != held[i];
    EXPECT_GT(built, 0) << knot;
    EXPECT_LE(built, 24) << knot;
  }
}

// Whatever came before: moves, another sun, no plants.
TEST(LandMesh, is_the_same_however_it_was_reached) {
  Site site;
  LandMesh kept = site.mesh();
  std::mt19937 bits(11);
  for (int i = 0; i < 8; ++i) {
    const auto uniform = [&] { return static_cast<float>(bits() / 4294967296.0 * 8 - 4); };
    const float x = uniform(), y = uniform(), z = uniform();
    site.move(bits() % 12, {x, y, z});
    const glm::vec3 sun = i % 4 == 3 ? kLowSun : kSun;
    const Plants* const plants = i % 3 == 2 ? nullptr : &site.plants;
    kept.update(site.ground, plants, sun, true, {});
    LandMesh fresh;
    fresh.update(site.ground, plants, sun, true, {});
    ASSERT_EQ(differing(kept, fresh), 0) << i;
  }
  site.document.park.seed = 9, site.update();
  kept.update(site.ground, &site.plants, kSun, true, {});
  EXPECT_EQ(differing(kept, site.mesh()), 0);
}

TEST(LandMesh, lies_in_the_sun_where_a_ray_to_it_meets_no_land) {
  const Site site(world::Land::valley);
  LandMesh mesh;
  mesh.update(site.ground, nullptr, kLowSun, true, {});
  int dark = 0, lit = 0, too_dark = 0, too_lit = 0;
  for (std::size_t patch = 0; patch < mesh.patches().size(); ++patch) {
    for (std::size_t i = 0; i < mesh.patches()[patch].light.size(); i += 37) {
      const glm::dvec3 from = glm::dvec3(mesh.place(patch, i)) + glm::dvec3(0, 0.5, 0);
      const auto met = site.ground.meet(from, glm::dvec3(kLowSun), 340);
      const auto higher = site.ground.meet(from + glm::dvec3(0, 3, 0), glm::dvec3(kLowSun), 340);
      if (met.has_value() != higher.has_value()) continue;  // at the edge of a shadow
      if (met && !site.ground.in_square(from.x + *met * double{kLowSun.x}, from.z + *met * double{kLowSun.z})) continue;
      (met ? dark : lit) += 1;
      const bool sunny = mesh.patches()[patch].light[i].sun >= 128;
      too_lit += met && sunny, too_dark += !met && !sunny;
    }
  }
  EXPECT_GT(dark, 100);
  EXPECT_GT(lit, 100);
  EXPECT_LT(too_dark, lit / 25);
  EXPECT_LT(too_lit, dark / 25);
}

TEST(LandMesh, sees_less_of_the_sky_in_a_valley) {
  Site site;
  site.document = test::ring_document(12, 95, 400);  // far above
  test::shape_land(site.document, [](double x, double) { return 2 * std::abs(x); });
  site.update();
  const LandMesh mesh = site.mesh();
  const LandField& field = mesh.field();
  int seen = 0;
  for (std::size_t patch = 0; patch < mesh.patches().size(); ++patch) {
    for (const LandVertex& vertex : mesh.vertices(patch)) {
      if (std::abs(vertex.position.z) > 60 || vertex.position.x != 0) continue;
      // The sides rise by 2 across the valley, by the square root of 2 halfway, and not at all along it: of the sky
      // 1/5, 1/3 and all are left.
      const float open = (2 * (1 / 5.0f) + 4 * (1 / 3.0f) + 2) / 8;
      const auto half = static_cast<int>(field.across / 2);
      const float wood =
          static_cast<float>(field.wood[field.at(half, half + static_cast<int>(vertex.position.z / 2))]) / 255;
      EXPECT_NEAR(vertex.finish.paint[3], 255 * (0.30f + 0.70f * open) * (1 - 0.35f * wood), 1.01);
      ++seen;
    }
  }
  EXPECT_GT(seen, 50);
}

TEST(LandMesh, sees_less_of_the_sky_between_walls_some_way_off) {
  Site site;
  site.document = test::ring_document(12, 95, 400);
  test::shape_land(site.document, [](double x, double) { return std::abs(x) > 9 ? 40 : 0; });
  site.update();
  LandMesh mesh;
  mesh.update(site.ground, nullptr, kSun, true, {});
  int seen = 0;
  for (std::size_t patch = 0; patch < mesh.patches().size(); ++patch)
    for (const LandVertex& vertex : mesh.vertices(patch))
      if (std::abs(vertex.position.z) < 60 && vertex.position.x == 0) {
        EXPECT_LT(vertex.finish.paint[3], 190);
        ++seen;
      }
  EXPECT_GT(seen, 50);
}

TEST(LandMesh, is_shaded_by_single_plants_in_part) {
  const Site site;
  const LandMesh mesh = site.mesh();
  const LandField& field = mesh.field();
  int trees = 0, bushes = 0;
  for (std::size_t i = 0; i < site.plants.patches(); ++i) {
    for (const sim::Plant& plant : site.plants.of(i)) {
      const auto near = [&](const sim::Plant& other) {
        return &other != &plant && other.kind != sim::PlantKind::rock &&
               glm::distance(glm::vec2(other.foot.x, other.foot.z), glm::vec2(plant.foot.x, plant.foot.z)) < 12;
      };
      const bool tree = plant.kind != sim::PlantKind::bush;
      bool alone = plant.kind != sim::PlantKind::rock && (tree ? trees < 12 : bushes < 4);
      for (std::size_t k = 0; alone && k < site.plants.patches(); ++k)
        alone = std::ranges::none_of(site.plants.of(k), near);
      if (!alone) continue;
      std::uint8_t most = 0;
      const auto cell = [&](float v) { return static_cast<int>(std::lround(v / 2)) + field.across / 2; };
      for (int z = -3; z <= 3; ++z)
        for (int x = -3; x <= 3; ++x)
          most = std::max(most, field.wood[field.at(cell(plant.foot.x) + x, cell(plant.foot.z) + z)]);
      EXPECT_LE(most, tree ? 141 : 102) << "of 255";
      EXPECT_GT(most, tree ? 70 : 10);
      (tree ? trees : bushes) += 1;
    }
  }
  EXPECT_GT(trees, 0);
  EXPECT_GT(bushes, 0);
}

TEST(LandMesh, is_lit_by_lamps_within_their_reach) {
  const Site site;
  LandMesh mesh = site.mesh();
  const glm::dvec2 place(40, 30);
  const auto height = static_cast<float>(site.ground.height(place.x, place.y));
  const std::vector<Lamp> lamps{{glm::vec3(40, height + 4, 30), 2, 0}};
  EXPECT_EQ(mesh.light_at(40, 30).lamp, 0);
  mesh.update(site.ground, &site.plants, kSun, true, lamps);
  EXPECT_GT(mesh.light_at(40, 30).lamp, 80);
  EXPECT_EQ(mesh.light_at(40 + 28, 30).lamp, 0);
  mesh.update(site.ground, &site.plants, kSun, true, {});
  EXPECT_EQ(differing(mesh, site.mesh()), 0);
}

TEST(LandPaint, shows_grey_rock_on_steep_snow_and_snow_on_level_ground) {
  const world::Park park = world::usual_park(world::Land::snow, 7);
  for (int i = 0; i < 40; ++i) {
    const double x = 13.0 * i, height = 4 + 0.7 * i;
    const glm::vec3 rock = land_paint(park, {x, -x, static_cast<float>(height), 0.2f, 0, 0}),
                    level = land_paint(park, {x, -x, static_cast<float>(height), 1, 0, 0});
    EXPECT_LT(rock.x, 0.4f) << i;
    EXPECT_NEAR(rock.x, rock.y, 0.04) << i;
    EXPECT_NEAR(rock.y, rock.z, 0.04) << i;
    EXPECT_GT(level.y, rock.y + 0.1f) << i;
  }
}

TEST(Lamps, stand_along_the_track_clear_of_it) {
  const Site site;
  const std::vector<Lamp> lamps = lamps_of(site.ground);
  EXPECT_GT(lamps.size(), static_cast<std::size_t>(site.derived.length / 18 / 2));
  for (const Lamp& lamp : lamps) {
    double nearest = 1e9;
    for (const TrackSample& sample : site.ground.samples())
      nearest = std::min(nearest, glm::distance(sample.at, glm::dvec3(lamp.at)));
    EXPECT_GT(nearest, 0.9);
    EXPECT_LT(nearest, 9);
  }
}

TEST(Fixtures, are_lit_by_lamps_and_map_their_light) {
  const Site site;
  const auto height = static_cast<float>(site.ground.height(40, 30));
  const std::vector<Lamp> lamps{{glm::vec3(40, height + 4.4f, 30), 2, 4.4f}};
  const FixtureMesh none = fixture_mesh(site.ground, {}, {}), dark = fixture_mesh(site.ground, lamps, {}),
                    lit = fixture_mesh(site.ground, lamps, lamps);
  ASSERT_GT(dark.vertices.size(), none.vertices.size());
  for (std::size_t i = none.vertices.size(); i < dark.vertices.size(); ++i) {
    EXPECT_LT(glm::distance(glm::vec2(dark.vertices[i].position.x, dark.vertices[i].position.z), {40, 30}), 0.5f);
    EXPECT_EQ(dark.light[i].lamp, 0);
    EXPECT_GT(lit.light[i].lamp, 0);
  }
  const std::vector<std::uint8_t> map = lamp_map(site.ground, lamps, {height, 10});
  const auto side = static_cast<std::size_t>(768 / kLampCell);
  const auto light = [&](double x, double z) {
    return map[2 * (static_cast<std::size_t>((z + 384) / kLampCell) * side +
                    static_cast<std::size_t>((x + 384) / kLampCell))];
  };
  EXPECT_GT(light(41, 31), 100);
  EXPECT_EQ(light(41 + 20, 31), 0);
}

TEST(LandPaint, follows_what_lies_on_a_place) {
  const world::Park hills = world::usual_park(world::Land::hills, 7),
                    desert = world::usual_park(world::Land::desert, 7);
  LandPlace place{.x = 100, .z = 40, .height = 30};
  const glm::vec3 grass = land_paint(hills, place), sand = land_paint(desert, place);
  EXPECT_GT(grass.y, grass.x);
  EXPECT_GT(sand.x, sand.y);
  place.upright = 0.3f;
  EXPECT_LT(land_paint(hills, place).y, land_paint(hills, place).x);  // rock
  place = {.x = 100, .z = 40, .height = 30, .wood = 1};
  EXPECT_LT(land_paint(hills, place).y, grass.y);
  place.earth = 1;
  EXPECT_EQ(land_paint(hills, place), land_paint(hills, {.x = -300, .z = 7, .height = 90, .earth = 1}));
  place = {.x = 100, .z = 40, .height = static_cast<float>(hills.water) - 5};
  EXPECT_EQ(land_paint(hills, place), land_paint(hills, {.x = -8, .z = 3, .height = place.height}));  // a lake's bed
}

}  // namespace land_mesh_test
}  // namespace coaster::sim
