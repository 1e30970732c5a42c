// Export of the track's shape: Wavefront OBJ, glTF 2.0, and drawings as SVG. They contain no knots, so they cannot be
// imported.
// imported.
#pragma once

#include <cstddef>
#include <string>

#include "base/status.h"
#include "world/document.h"

namespace coaster::exchange {

// Checks that print_obj() and print_gltf() take at most about 1 GB of memory: Code::refused for solids of more
// vertices.
inline constexpr std::size_t kMostSolidVertices = 3'000'000;
base::Status check_solid(const world::Document& document);

// Returns text with the groups "rails", "spine" and "ties" (v, vn, f, counter-clockwise from outside) and "centre_line"
// (one l element). Metres, Y up; every number in its shortest exact form. Sections with paint of their own have groups
// of their own: "rails_q2".
std::string print_obj(const world::Document& document);
// The same with the park that the document has: groups "land", "water", "fixtures" and one for each kind of plants,
// with colours at vertices as shown on screen. At most about 1.5 million vertices more.
std::string print_obj_park(const world::Document& document);
// Returns the .mtl file with the materials that they name.
std::string obj_materials(const world::Document& document, bool with_park);

// Returns glTF 2.0 (Khronos, registry.khronos.org/glTF/specs/2.0), one JSON file with an embedded buffer: mesh "track"
// with a primitive and a material each for rails, spine and ties, and mesh "centre line", a LINE_STRIP. Metres, Y up. A
// track without segments gives a scene without nodes.
std::string print_gltf(const world::Document& document);
// The same with the park that the document has: mesh "park" with primitives for land, water and fixtures, and a mesh
// for each kind of plants with a node for every plant. Colours at vertices, in linear light.
std::string print_gltf_park(const world::Document& document);

// Returns a plan (x to the right, z down, as seen from above) and an elevation (x to the right, y up), in metres at one
// scale, each with a scale bar. The paths are cubics with the coordinates of the control points: exact at any
// magnification.
std::string print_svg(const world::Document& document);

}  // namespace coaster::exchange
