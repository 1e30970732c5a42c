// The swept solid of one segment: two rails, a spine and cross-ties, as triangles. Pure function of the shape; the vertex-buffer
// cache calls it only when the shape's build number changes.
#pragma once

#include <cstdint>
#include <vector>

#include <glm/glm.hpp>

#include "sim/derived.h"

namespace coaster::sim {

enum class Part : std::uint8_t { rail, spine, tie, body, stripe, wheel };

struct MeshVertex {
  glm::vec3 position;
  glm::vec3 normal;   // unit
  float part;         // static_cast<float>(Part): the shader picks the colour
  float along = 0;    // place on the segment, arc length over length, 0..1
  float segment = 0;  // the entity's index, filled in by who draws the track
};

struct Mesh {
  std::vector<MeshVertex> vertices;
  std::vector<std::uint32_t> indices;  // triangles, counter-clockwise seen from outside
};

inline constexpr double kGauge = 1.2;       // m between the rails' axes
inline constexpr double kRailRadius = 0.12;  // m
inline constexpr double kSpineRadius = 0.28;  // m
inline constexpr double kSpineDrop = 0.62;   // m below the rails' plane
inline constexpr double kTieSpacing = 1.5;   // m between ties, about: a whole number fits a segment
inline constexpr int kTubeSides = 8;
inline constexpr int kMaxRings = 400;        // of a segment

// Rings lie closer where the curve bends; the rings at both ends depend on the joint's frame alone, so neighbours meet without a crack.
// About 6 degrees of bend or twist and at most 3 m from ring to ring where it bends, 2 to kMaxRings rings; a straight segment
// has 2. Tubes have smooth normals and are closed at both ends. Replaces what `mesh` holds. A segment without length gives
// tubes without length, never NaN.
void sweep_track(const SegmentShape& shape, Mesh& mesh);

// A cart of 2.2 x 1.3 x 1.1 m about the origin: forward +X, up +Y, left -Z; the rails' plane at y = 0.
Mesh cart_mesh();

}  // namespace coaster::sim
