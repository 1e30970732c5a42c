// The train's meshes: models of its cars and couplings, each instanced for every car. Around the origin: forward +X, up
// +Y, left -Z, the rails' plane at y = 0.
#pragma once

#include "sim/solids/coaster_form.h"

namespace coaster::sim {

inline constexpr double kHitchBack = 1.0;  // m from a car's middle to its hitches, for a car of world::kCarLength

// Who sits in a car: one of two groups of people, with hands on the bar or raised.
inline constexpr int kRiderGroups = 2;
struct CarRiders {
  std::uint8_t group = 0;
  bool arms_up = false;
  friend bool operator==(const CarRiders&, const CarRiders&) = default;
};

// Returns a car of 2.2 m of a kind: body, chassis, wheels above, beside and below the rails, two rows of two riders,
// who hang below the rails on an inverted coaster. A leading car has a nose; that of a mine train is a locomotive, with
// riders in the tender.
Mesh car_mesh(world::CoasterKind kind, bool leading, CarRiders riders = {});
// Returns the body of a car only, as a block: 12 triangles.
Mesh distant_car_mesh(world::CoasterKind kind);
// Returns a bar from the origin to (1, 0, 0).
Mesh coupling_mesh();

// Adds an ellipsoid with half axes along x, y, z.
void add_ball(glm::dvec3 middle, glm::dvec3 half, int sides, Material part, Mesh& mesh);

}  // namespace coaster::sim
