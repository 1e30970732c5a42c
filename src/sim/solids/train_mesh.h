// The train as it is drawn: models of its cars and of what couples them, each drawn once for every car. About the
// origin: forward +X, up +Y, left -Z, the rails' plane at y = 0.
#pragma once

#include "sim/solids/mesh.h"

namespace coaster::sim {

inline constexpr double kHitchHeight = 0.21;  // m over the rails' plane, of couplings
inline constexpr double kHitchBack = 1.0;     // m from a car's middle to its hitches, for a car of world::kCarLength
inline constexpr double kWheelRoom = 0.38;    // m about a rail's axis, within which wheels and what carries them are

// A car of 2.2 m: body, chassis, wheels over, beside and under the rails, two rows of two riders. A leading car has a
// rounded nose.
Mesh car_mesh(bool leading);
// A bar from the origin to (1, 0, 0).
Mesh coupling_mesh();

// A solid through sections of equally many corners, back to front, counter-clockwise as seen from the front; smooth but
// at both ends. parts[k] is what lies between corners k and k + 1.
void add_loft(std::span<const std::vector<glm::dvec3>> sections, std::span<const Part> parts, Mesh& mesh);
// An ellipsoid with half axes along x, y, z.
void add_ball(glm::dvec3 middle, glm::dvec3 half, int sides, Part part, Mesh& mesh);
// A rider whose hip is at `hip`, looking along +X, hands on the bar before him.
void add_rider(glm::dvec3 hip, Part shirt, Part trousers, Mesh& mesh);

}  // namespace coaster::sim
