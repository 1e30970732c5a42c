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
// (one l element). Metres, Y up; every number in its shortest exact form.
std::string print_obj(const world::Document& document);
std::string obj_materials(const world::Document& document);  // the .mtl file with the materials that print_obj() names

// Returns glTF 2.0 (Khronos, registry.khronos.org/glTF/specs/2.0), one JSON file with an embedded buffer: mesh "track"
// with a primitive and a material each for rails, spine and ties, and mesh "centre line", a LINE_STRIP. Metres, Y up. A
// track without segments gives a scene without nodes.
std::string print_gltf(const world::Document& document);

// Returns a plan (x to the right, z down, as seen from above) and an elevation (x to the right, y up), in metres at one
// scale, each with a scale bar. The paths are cubics with the coordinates of the control points: exact at any
// magnification.
std::string print_svg(const world::Document& document);

}  // namespace coaster::exchange
