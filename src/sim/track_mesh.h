// The swept solid of one segment: two rails, a spine and cross-ties, as triangles. Pure function of the shape; the vertex-buffer
// cache calls it only when the shape's build number changes.
#pragma once

#include <cstdint>
#include <vector>

#include <glm/glm.hpp>

#include "sim/derived.h"

namespace coaster::sim {

enum class Part : std::uint8_t { rail, spine, tie };

struct MeshVertex {
  glm::vec3 position;
  glm::vec3 normal;   // unit
  float part;         // static_cast<float>(Part): the shader picks the colour
};

struct Mesh {
  std::vector<MeshVertex> vertices;
  std::vector<std::uint32_t> indices;  // triangles, counter-clockwise seen from outside
};

inline constexpr double kGauge = 1.2;       // m between the rails' axes
inline constexpr double kRailRadius = 0.09;  // m
inline constexpr double kSpineRadius = 0.19;  // m
inline constexpr double kSpineDrop = 0.55;   // m below the rails' plane
inline constexpr double kTieSpacing = 1.5;   // m between ties, about: a whole number fits a segment

// Rings lie closer where the curve bends; the rings at both ends depend on the joint's frame alone, so neighbours meet without a crack.
void sweep_track(const SegmentShape& shape, Mesh& mesh);

// A cart of 2.2 x 1.3 x 1.1 m about the origin: forward +X, up +Y, left -Z; the rails' plane at y = 0.
Mesh cart_mesh();

}  // namespace coaster::sim
