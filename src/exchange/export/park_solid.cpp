// The park of an export: land, water, tunnels, stations and plants as triangles.
#include <algorithm>
#include <cmath>

#include "exchange/export/solid_parts_detail.h"
#include "sim/ground/fixtures.h"
#include "sim/ground/land_mesh.h"
#include "sim/ground/noise.h"
#include "sim/solids/materials.h"
#include "sim/solids/station_mesh.h"

namespace coaster::exchange {
namespace {

constexpr std::size_t kMostCoarsePlants = 20'000;  // more of them are printed still coarser, not once

void add(const std::vector<sim::LandVertex>& vertices, const auto& indices, SolidPart& part) {
  const auto first = static_cast<std::uint32_t>(part.positions.size());
  for (const sim::LandVertex& vertex : vertices) {
    const auto& [normal, paint] = vertex.finish;
    const glm::vec3 root = glm::vec3(paint[0], paint[1], paint[2]) / 255.0f;
    part.positions.push_back(vertex.position);
    part.normals.push_back(glm::normalize(glm::vec3(normal[0], normal[1], normal[2])));
    part.colours.push_back(0.5f * (1 + static_cast<float>(paint[3]) / 255) * root * root);
  }
  for (const auto i : indices) part.indices.push_back(first + i);
}

// Adds rectangles at the water's level over the cells of a patch that it covers, one for each run of them along x.
void add_water(const sim::GroundPatch& patch, double level, SolidPart& water) {
  const auto cell = static_cast<float>(world::kGroundCell), y = static_cast<float>(level);
  const auto wet = [&](int x, int z) {
    return x < world::kGroundTileCells && std::min({patch.height(x, z), patch.height(x + 1, z), patch.height(x, z + 1),
                                                    patch.height(x + 1, z + 1)}) < y;
  };
  for (int z = 0; z < world::kGroundTileCells; ++z) {
    for (int x = 0, end = 0; x < world::kGroundTileCells; x = end + 1) {
      for (end = x; wet(end, z);) ++end;
      if (end == x) continue;
      const auto first = static_cast<std::uint32_t>(water.positions.size());
      for (const glm::vec2 corner : {glm::vec2(x, z), glm::vec2(x, z + 1), glm::vec2(end, z + 1), glm::vec2(end, z)}) {
        const glm::vec2 at = patch.corner() + cell * corner;
        water.positions.emplace_back(at.x, y, at.y);
        water.normals.emplace_back(0, 1, 0);
      }
      for (const std::uint32_t i : {0u, 1u, 2u, 0u, 2u, 3u}) water.indices.push_back(first + i);
    }
  }
}

void add_stations(const sim::Mesh& mesh, const world::Paint& paint, SolidPart& part) {
  for (const sim::MeshVertex& vertex : mesh.vertices) {
    const sim::MaterialRow& row = sim::kMaterials.at(static_cast<std::size_t>(vertex.part));
    const world::Colour own = row.painted ? paint.of(*row.painted) : world::Colour();
    part.positions.push_back(vertex.position);
    part.normals.push_back(vertex.normal);
    part.colours.push_back(own.own() ? linear(own) : linear(row.colour));
  }
  part.indices.assign(mesh.indices.begin(), mesh.indices.end());
}

// Snow lies on what faces up to the sky.
void add_snow(const sim::PlantModel& model, SolidPart& part) {
  for (std::size_t i = 0; i < part.colours.size(); ++i) {
    const double open = static_cast<double>(model.vertices[i].finish.paint[3]) / 255;
    const double much =
        0.85 * sim::smooth_step(0.05, 0.6, double{part.normals[i].y}) * sim::smooth_step(0.3, 0.9, open);
    part.colours[i] = glm::mix(part.colours[i], glm::vec3(0.74f, 0.78f, 0.84f), static_cast<float>(much));
  }
}

}  // namespace

ParkSolid::ParkSolid() {
  constexpr const char* kNames[] = {"conifers", "broadleaves", "bushes", "rocks"};
  for (std::size_t kind = 0; kind < plants.size(); ++kind) plants[kind].model = {kNames[kind], glm::vec3(1), 0, 1};
}

glm::vec3 linear(glm::vec3 shown) {
  for (int i = 0; i < 3; ++i)
    shown[i] = shown[i] <= 0.04045f ? shown[i] / 12.92f : std::pow((shown[i] + 0.055f) / 1.055f, 2.4f);
  return shown;
}
glm::vec3 linear(world::Colour colour) {
  return linear(glm::vec3(colour.rgb >> 16 & 255, colour.rgb >> 8 & 255, colour.rgb & 255) / 255.0f);
}

ParkSolid park_solid(const world::Document& document, const sim::DerivedTrack& derived, const sim::Ground& ground,
                     bool once) {
  ParkSolid park;
  sim::Plants plants;
  plants.update(ground);
  sim::LandMesh mesh;
  mesh.update(ground, &plants, {0, 1, 0}, false, {});
  auto& [land, water, fixtures, stations] = park.parts;
  std::size_t count = 0;
  for (std::size_t i = 0; i < ground.patches().size(); ++i) {
    add(mesh.vertices(i), mesh.triangles(i), land);
    add_water(ground.patches()[i], ground.water(), water);
    for (const sim::Plant& plant : plants.of(i))
      park.plants[static_cast<std::size_t>(plant.kind)].plants.push_back(plant);
    count += plants.of(i).size();
  }
  const sim::FixtureMesh built = sim::fixture_mesh(ground, sim::lamps_of(ground), {});
  add(built.vertices, built.indices, fixtures);
  add_stations(sim::station_mesh(derived, ground, document.name),
               world::over(document.paint, base::row_of(document.kind).paint), stations);
  const sim::PlantLevel level = once                         ? sim::PlantLevel::fine
                                : count <= kMostCoarsePlants ? sim::PlantLevel::coarse
                                                             : sim::PlantLevel::far;
  for (std::size_t kind = 0; kind < park.plants.size(); ++kind) {
    const sim::PlantModel model = sim::plant_model(static_cast<sim::PlantKind>(kind), level);
    add(model.vertices, model.indices, park.plants[kind].model);
    if (ground.land().park().land == world::Land::snow) add_snow(model, park.plants[kind].model);
  }
  return park;
}

SolidPart planted(const PlantParts& parts) {
  const SolidPart& model = parts.model;
  SolidPart all{model.name, model.colour, model.metallic, model.roughness};
  for (const sim::Plant& plant : parts.plants) {
    const auto turned = [&](glm::vec3 v) {
      return glm::vec3(plant.turn.x * v.x - plant.turn.y * v.z, v.y, plant.turn.y * v.x + plant.turn.x * v.z);
    };
    const auto first = static_cast<std::uint32_t>(all.positions.size());
    for (std::size_t i = 0; i < model.positions.size(); ++i) {
      all.positions.push_back(glm::round(100.0f * (plant.foot + plant.size * turned(model.positions[i]))) / 100.0f);
      all.normals.push_back(glm::round(100.0f * turned(model.normals[i])) / 100.0f);
    }
    all.colours.insert(all.colours.end(), model.colours.begin(), model.colours.end());
    for (const std::uint32_t i : model.indices) all.indices.push_back(first + i);
  }
  return all;
}

}  // namespace coaster::exchange
