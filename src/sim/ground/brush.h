// Strokes of brushes on the land as people left it. A stroke touches only vertices within its radius, strongly in the
// middle and not at all at its rim.
#pragma once

#include <optional>

#include <glm/glm.hpp>

#include "sim/ground/land.h"

namespace coaster::sim {

struct Brush {
  glm::dvec2 at{0};   // m, (x, z) of its middle
  double radius = 1;  // m, above 0
};

// Each returns the tiles of the land with the stroke; those that the stroke does not change are shared. Heights are
// rounded to world::kHeightStep and kept within world::kHighestGround. The land is not plain.
world::GroundTiles raised(const Land& land, Brush brush, double by);     // m, in the middle; negative lowers
world::GroundTiles smoothed(const Land& land, Brush brush);              // towards the mean of the surroundings
world::GroundTiles flattened(const Land& land, Brush brush, double to);  // m
// A strip of that radius between two places, straight between their heights.
world::GroundTiles sloped(const Land& land, glm::dvec2 from, glm::dvec2 to, double radius);
// Wooded as far as 0 (none) to 1 (dense), or without a value as the land has it; ragged at the rim.
world::GroundTiles wooded(const Land& land, Brush brush, std::optional<double> to);

}  // namespace coaster::sim
