// The park in glTF and OBJ, and what sections paint.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>
#include <glm/gtc/quaternion.hpp>

#include "base/scratch_folder.h"
#include "exchange/export/shape_export.h"
#include "exchange/export/shape_readers.h"
#include "exchange/export/solid_parts_detail.h"
#include "exchange/formats.h"
#include "sim/ground/plants.h"
#include "sim/ground/tunnel_mesh.h"
#include "sim/solids/coaster_form.h"
#include "sim/tracks.h"
#include "world/sections.h"

namespace coaster::exchange {
namespace park_solid_test {

using test::Gltf;
using test::Obj;

constexpr const char* kNames[] = {"conifers", "broadleaves", "bushes", "rocks"};  // by sim::PlantKind

// A ring of track, half of it through a hill of 30 m.
struct ParkSolids : testing::Test {
  world::Document document = test::ring_document(12, 95, 9);
  sim::Ground ground;
  sim::Plants plants;

  // `woods`: part of the usual ones. Plants take most of an OBJ's text.
  void stand_in(world::Land land, double woods = 1) {
    document.park = world::usual_park(land, 7);
    document.park.woods *= woods;
    std::vector<std::pair<world::TilePlace, world::GroundTile>> hill;
    for (std::int16_t x = 0; x < 3; ++x)
      for (std::int16_t z = -3; z < 3; ++z) {
        world::GroundTile tile;
        tile.heights.fill(30 * 32);
        hill.emplace_back(world::TilePlace{x, z}, tile);
      }
    document.park.tiles.put(hill);
    for (const world::Entity knot : document.track.knots) document.entities.get<world::Knot>(knot).position.y -= 6;
    world::settle_joints(document);
    sim::DerivedTrack derived;
    sim::derive(document, {}, {}, derived);
    ground.update(document, derived, sim::track_room(sim::form_of(document.kind)));
    plants.update(ground);
  }
  std::vector<sim::Plant> plants_of(std::size_t kind) const {
    std::vector<sim::Plant> found;
    for (std::size_t patch = 0; patch < plants.patches(); ++patch)
      for (const sim::Plant& plant : plants.of(patch))
        if (static_cast<std::size_t>(plant.kind) == kind) found.push_back(plant);
    return found;
  }
  // The cells that the drawn land leaves open.
  int open_cells() const {
    int count = 0;
    for (int z = -192; z < 192; ++z)
      for (int x = -192; x < 192; ++x) count += sim::is_open(ground, {x, z});
    return count;
  }
  // Cells with a vertex under water.
  int wet_cells() const {
    int count = 0;
    for (int z = -192; z < 192; ++z)
      for (int x = -192; x < 192; ++x) {
        double low = 1e9;
        for (int k = 0; k < 4; ++k) low = std::min(low, ground.height(2 * (x + k % 2), 2 * (z + k / 2)));
        count += low < ground.water();
      }
    return count;
  }
};

// The area of triangles seen from above, all of which face up.
double area(const std::vector<glm::vec3>& positions, const std::vector<std::uint32_t>& indices) {
  double sum = 0;
  for (std::size_t i = 0; i + 2 < indices.size(); i += 3) {
    const glm::dvec3 a(positions.at(indices[i])), b(positions.at(indices[i + 1])), c(positions.at(indices[i + 2]));
    const double twice = glm::cross(b - a, c - a).y;
    EXPECT_GT(twice, 0);
    sum += 0.5 * twice;
  }
  return sum;
}

TEST_F(ParkSolids, the_land_is_the_ground_cut_to_the_track) {
  stand_in(world::Land::hills);
  ASSERT_FALSE(ground.tunnels().empty());
  const Gltf gltf(print_gltf_park(document));
  const Json& land = gltf.primitive("park", "land");
  const auto positions = gltf.positions(land);
  const auto indices = gltf.items<std::uint32_t>(land["indices"], "SCALAR", 5125);
  for (const glm::vec3 p : positions) ASSERT_EQ(p.y, static_cast<float>(ground.height(p.x, p.z)));
  // Between the vertices, too.
  for (std::size_t i = 0; i < indices.size(); i += 3 * 97) {
    const glm::vec3 middle = (positions[indices[i]] + positions[indices[i + 1]] + positions[indices[i + 2]]) / 3.0f;
    ASSERT_NEAR(middle.y, ground.height(middle.x, middle.z), 1e-3);
  }
  EXPECT_GT(open_cells(), 0);
  EXPECT_NEAR(area(positions, indices), 768 * 768 - 4 * open_cells(), 1);
  const auto normals = gltf.items<glm::vec3>(land["attributes"]["NORMAL"], "VEC3", 5126);
  const auto colours = gltf.items<glm::vec3>(land["attributes"]["COLOR_0"], "VEC3", 5126);
  ASSERT_EQ(normals.size(), positions.size());
  ASSERT_EQ(colours.size(), positions.size());
  for (const glm::vec3 n : normals) ASSERT_TRUE(std::fabs(glm::length(n) - 1) < 1e-5 && n.y > 0);
  int green = 0;
  for (const glm::vec3 c : colours) {
    ASSERT_TRUE(std::min({c.x, c.y, c.z}) >= 0 && std::max({c.x, c.y, c.z}) <= 1);
    green += c.y > c.x && c.y > c.z;
  }
  EXPECT_GT(green, static_cast<int>(colours.size() / 2)) << "grass";
  // Tunnels are where the track is in one.
  const auto built = gltf.positions(gltf.primitive("park", "fixtures"));
  for (const sim::TrackSample& sample : ground.samples()) {
    double nearest = 1e9;
    for (const glm::vec3 p : built) nearest = std::min(nearest, glm::distance(glm::dvec3(p), sample.at));
    EXPECT_TRUE(!sample.tunnel || nearest < ground.room().tube + 1.5);
  }
}

TEST_F(ParkSolids, water_covers_what_lies_below_its_level) {
  stand_in(world::Land::meadow);
  const Gltf gltf(print_gltf_park(document));
  const Json& water = gltf.primitive("park", "water");
  const auto positions = gltf.positions(water);
  for (const glm::vec3 p : positions) ASSERT_EQ(p.y, static_cast<float>(ground.water()));
  ASSERT_GT(wet_cells(), 100);
  EXPECT_NEAR(area(positions, gltf.items<std::uint32_t>(water["indices"], "SCALAR", 5125)), 4.0 * wet_cells(), 0.1);
  const Json& material = gltf.file["materials"].at(water["material"].get<std::size_t>());
  EXPECT_EQ(material["alphaMode"].get<std::string>(), "BLEND");
  EXPECT_LT(material["pbrMetallicRoughness"]["baseColorFactor"].at(3).get<double>(), 1);
}

TEST_F(ParkSolids, every_plant_is_a_node_of_its_kinds_model) {
  stand_in(world::Land::hills);
  const Gltf gltf(print_gltf_park(document));
  int trees = 0;
  for (std::size_t kind = 0; kind < 4; ++kind) {
    const std::vector<sim::Plant> there = plants_of(kind);
    const std::size_t mesh = gltf.named("meshes", kNames[kind]);
    const Json& children = gltf.file["nodes"].at(gltf.named("nodes", kNames[kind]))["children"];
    ASSERT_EQ(children.size(), there.size());
    if (kind < 2) trees += static_cast<int>(children.size());
    for (std::size_t i = 0; i < there.size(); ++i) {
      const Json& node = gltf.file["nodes"].at(children[i].get<std::size_t>());
      ASSERT_EQ(node["mesh"].get<std::size_t>(), mesh);
      for (int axis = 0; axis < 3; ++axis) {
        ASSERT_NEAR(node["translation"].at(axis).get<double>(), there[i].foot[axis], 0.00051);
        ASSERT_NEAR(node["scale"].at(axis).get<double>(), there[i].size, 0.00051);
      }
      ASSERT_NEAR(node["translation"].at(1).get<double>(), ground.height(there[i].foot.x, there[i].foot.z), 0.001);
      const Json& r = node["rotation"];
      const glm::dquat turn(r.at(3).get<double>(), r.at(0).get<double>(), r.at(1).get<double>(), r.at(2).get<double>());
      ASSERT_NEAR(glm::length(turn), 1, 1e-9);
      const glm::dvec3 x = turn * glm::dvec3(1, 0, 0), wanted(there[i].turn.x, 0, there[i].turn.y);
      ASSERT_LT(glm::distance(x, wanted), 1e-3);
    }
  }
  EXPECT_EQ(trees, plants.trees());
  EXPECT_GT(trees, 500);
}

TEST_F(ParkSolids, the_obj_has_the_same_land_and_a_copy_of_a_model_for_every_plant) {
  stand_in(world::Land::island, 0.1);
  const Gltf gltf(print_gltf_park(document));
  const Obj obj = test::read_obj(print_obj_park(document));
  for (const char* const part : {"land", "water", "fixtures"}) {
    const Json& primitive = gltf.primitive("park", part);
    const auto positions = gltf.positions(primitive);
    const auto indices = gltf.items<std::uint32_t>(primitive["indices"], "SCALAR", 5125);
    const std::vector<std::uint32_t>& faces = obj.faces.at(part);
    ASSERT_EQ(indices.size(), faces.size());
    for (std::size_t i = 0; i < indices.size(); ++i) ASSERT_EQ(positions[indices[i]], obj.v.at(faces[i]));
  }
  for (std::size_t kind = 0; kind < 4; ++kind) {
    const std::vector<sim::Plant> there = plants_of(kind);
    ASSERT_FALSE(there.empty());
    const std::vector<std::uint32_t>& faces = obj.faces.at(kNames[kind]);
    ASSERT_EQ(faces.size() % there.size(), 0u);
    const std::size_t each = faces.size() / there.size();
    for (std::size_t i = 0; i < faces.size(); ++i) {
      const sim::Plant& plant = there[i / each];
      const glm::vec3 off = (obj.v.at(faces[i]) - plant.foot) / plant.size;
      ASSERT_TRUE(std::hypot(off.x, off.z) < 3.5f && off.y > -0.7f && off.y < 10.1f) << kNames[kind];
    }
  }
  ASSERT_FALSE(obj.vc.empty());
  for (const glm::vec3 c : obj.vc) ASSERT_TRUE(std::min({c.x, c.y, c.z}) >= 0 && std::max({c.x, c.y, c.z}) <= 1);
  // Every group has a material.
  const std::string materials = obj_materials(document, true);
  for (const auto& [group, faces] : obj.faces) EXPECT_NE(materials.find("newmtl " + group + "\n"), std::string::npos);
  EXPECT_EQ(obj_materials(document, false).find("land"), std::string::npos);
}

TEST_F(ParkSolids, without_the_word_the_files_hold_the_track_alone) {
  stand_in(world::Land::hills, 0.1);
  const Gltf plain(print_gltf(document)), park(print_gltf_park(document));
  EXPECT_EQ(plain.file["nodes"].size(), 2u);
  ASSERT_GT(park.buffer.size(), plain.buffer.size());
  EXPECT_EQ(park.buffer.substr(0, plain.buffer.size()), plain.buffer) << "the track comes first and is the same";
  const std::string track = print_obj(document), all = print_obj_park(document);
  const std::size_t line = track.find("g centre_line");
  EXPECT_EQ(all.substr(0, line), track.substr(0, line));
  // The line's vertices have other numbers, but are the same.
  const auto vertices = [](const std::string& text) {
    const std::size_t from = text.find("g centre_line");
    return text.substr(from, text.find("\nl ", from) - from);
  };
  EXPECT_EQ(vertices(all), vertices(track));
}

TEST_F(ParkSolids, snow_lies_on_plants) {
  const auto mean = [&](world::Land land) {
    document.park = world::usual_park(land, 7);
    sim::DerivedTrack derived;
    sim::derive(document, {}, {}, derived);
    ground.update(document, derived, sim::track_room(sim::form_of(document.kind)));
    glm::vec3 sum(0);
    const SolidPart conifers = park_solid(document, derived, ground, true).plants[0].model;
    for (const glm::vec3 colour : conifers.colours) sum += colour;
    return sum / static_cast<float>(conifers.colours.size());
  };
  const glm::vec3 hills = mean(world::Land::hills), snow = mean(world::Land::snow);
  EXPECT_GT(hills.y, 1.5f * hills.z) << "green";
  EXPECT_GT(snow.z, 4 * hills.z);
  EXPECT_GT(snow.z, snow.x) << "bluish";
}

TEST_F(ParkSolids, files_of_dense_woods_are_bounded) {
  stand_in(world::Land::snow);
  document.park.woods = 1;
  const std::string gltf = print_gltf_park(document);
  EXPECT_LT(gltf.size(), std::size_t{40} << 20);
  EXPECT_LT(print_obj_park(document).size(), std::size_t{120} << 20);
}

TEST_F(ParkSolids, are_refused_without_a_land_and_in_other_formats) {
  const test::ScratchFolder scratch;
  base::Files files;
  const auto save = [&](const char* name) {
    return save_track(files, scratch.path() / name, document, nullptr, base::ReplaceableFiles::made, true);
  };
  const base::Status plain = save("a.gltf");
  EXPECT_EQ(plain.code, base::Code::refused);
  EXPECT_NE(plain.message.find("a.gltf: error: the track has no park"), std::string::npos) << plain.message;
  stand_in(world::Land::desert);
  for (const char* const name : {"a.json", "a.svg", "a.csv"}) {
    const base::Status other = save(name);
    EXPECT_EQ(other.code, base::Code::refused);
    EXPECT_NE(other.message.find("only .gltf and .obj"), std::string::npos) << other.message;
    EXPECT_FALSE(std::filesystem::exists(scratch.path() / name));
  }
  ASSERT_TRUE(save("a.obj"));
  EXPECT_NE(files.read(scratch.path() / "a.mtl")->find("newmtl land"), std::string::npos);
}

TEST(SectionPaint, gives_a_section_parts_of_its_own) {
  world::Document d = test::closed_document();
  const Gltf before(print_gltf(d));
  const world::Entity section = world::segment(d, d.track.segments[1]).section;
  ASSERT_TRUE(section.valid());
  d.entities.get<world::Section>(section).paint = {.rails = {0xff0000}, .supports = {0x0000ff}};
  const std::string own = "_" + world::to_text(world::name_of(d, section));
  const Gltf gltf(print_gltf(d));
  const auto count = [](const Gltf& of, const std::string& name) {
    const Json& primitive = of.primitive("track", name);
    return of.items<std::uint32_t>(primitive["indices"], "SCALAR", 5125).size();
  };
  EXPECT_EQ(
      gltf.file["materials"].at(gltf.named("materials", "rails" + own))["pbrMetallicRoughness"]["baseColorFactor"],
      Json::parse("[1.0,0.0,0.0,1.0]"));
  std::size_t same_paint = 0;
  for (const world::Entity segment : d.track.segments) same_paint += world::segment(d, segment).section == section;
  if (same_paint == d.track.segments.size()) EXPECT_EQ(count(gltf, "rails" + own), count(before, "rails"));
  else EXPECT_EQ(count(gltf, "rails" + own) + count(gltf, "rails"), count(before, "rails"));
  EXPECT_EQ(count(gltf, "spine"), count(before, "spine")) << "not painted";
  for (const Json& material : gltf.file["materials"]) EXPECT_NE(material["name"].get<std::string>(), "spine" + own);
  const Obj obj = test::read_obj(print_obj(d));
  EXPECT_EQ(obj.faces.at("rails" + own).size(), count(gltf, "rails" + own));
  const std::string materials = obj_materials(d, false);
  EXPECT_NE(materials.find("newmtl supports" + own + "\nKd 0 0 1\n"), std::string::npos) << materials;
}

}  // namespace park_solid_test
}  // namespace coaster::exchange
