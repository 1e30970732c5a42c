// The train's meshes: models of its cars and couplings, each instanced for every car. Around the origin: forward +X, up
// +Y, left -Z, the rails' plane at y = 0.
#pragma once

#include "sim/solids/mesh.h"

namespace coaster::sim {

inline constexpr double kHitchHeight = 0.21;  // m above the rails' plane, of couplings
inline constexpr double kHitchBack = 1.0;     // m from a car's middle to its hitches, for a car of world::kCarLength
inline constexpr double kWheelRoom = 0.38;    // m about a rail's axis, clearance for wheels and bogies

// Returns a car of 2.2 m: body, chassis, wheels above, beside and below the rails, two rows of two riders. A leading
// car has a rounded nose.
Mesh car_mesh(bool leading);
// Returns the body of a car only, as a block: 12 triangles.
Mesh distant_car_mesh();
// Returns a bar from the origin to (1, 0, 0).
Mesh coupling_mesh();

// Adds an ellipsoid with half axes along x, y, z.
void add_ball(glm::dvec3 middle, glm::dvec3 half, int sides, Material part, Mesh& mesh);

}  // namespace coaster::sim
