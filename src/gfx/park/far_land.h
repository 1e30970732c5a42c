// The land beyond the square: rings of triangles out to the horizon, which begin at the square's edge.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "sim/ground/land_mesh.h"

namespace coaster::gfx {

struct FarLand {
  std::vector<sim::LandVertex> vertices;
  std::vector<std::uint16_t> indices;    // by the sides of the square
  std::array<std::uint32_t, 5> sides{};  // where each side's indices begin, and their end
  float low = 0, high = 0;               // m
};
// Returns the far land around the ground's square, whose patches' borders at every fourth vertex it continues.
FarLand far_land(const sim::Ground& ground, const sim::LandField& field);

inline constexpr float kFarthestLand = 18;  // half sides of the square, level, along an axis

}  // namespace coaster::gfx
