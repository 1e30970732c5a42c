// What the exports of solids print: parts of the track, and of the park around it.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include <glm/glm.hpp>

#include "sim/ground/plant_models.h"
#include "sim/shape/derived_track.h"

namespace coaster::exchange {

// Triangles of one material, counter-clockwise seen from outside; may be empty.
struct SolidPart {
  std::string name;
  glm::vec3 colour{1};  // linear red, green, blue
  double metallic = 0.6, roughness = 0.5, opacity = 1;
  std::vector<glm::vec3> positions;  // m
  std::vector<glm::vec3> normals;    // unit, one per position
  std::vector<glm::vec3> colours;    // linear, one per position; empty: `colour` for all
  std::vector<std::uint32_t> indices;
};

// Plants of one kind, and the model of one of size 1 about its foot.
struct PlantParts {
  SolidPart model;
  std::vector<sim::Plant> plants;
};

struct ParkSolid {
  std::array<SolidPart, 4> parts{SolidPart{"land", glm::vec3(1), 0, 1},
                                 SolidPart{"water", {0.03f, 0.10f, 0.12f}, 0, 0.1, 0.75},
                                 SolidPart{"fixtures", glm::vec3(1), 0, 1},  // tunnels and posts of lamps
                                 SolidPart{"stations", glm::vec3(1), 0, 1}};
  std::array<PlantParts, sim::kPlantKinds> plants;  // by sim::PlantKind
  ParkSolid();                                      // names and materials alone
};

// Returns the land in its square, cut to the track as it is drawn, its water, what is built on it, and its plants.
// `once`: each model is printed once, else for every plant, and is then coarse. Half of the shade that the sky's light
// leaves is in the colours.
ParkSolid park_solid(const world::Document& document, const sim::DerivedTrack& derived, const sim::Ground& ground,
                     bool once);

// Returns linear light of a colour on the screen.
glm::vec3 linear(glm::vec3 shown);
glm::vec3 linear(world::Colour colour);

// Returns all plants as triangles, in whole centimetres.
SolidPart planted(const PlantParts& parts);

}  // namespace coaster::exchange
