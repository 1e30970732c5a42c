// The whole track as triangles and a line, for formats that hold shapes alone. Private to this room.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include "world/document.h"

namespace coaster::exchange {

// One part of the track: triangles, counter-clockwise seen from outside.
struct SolidPart {
  std::string_view name;
  std::vector<glm::vec3> positions;  // m
  std::vector<glm::vec3> normals;    // unit, one a position
  std::vector<std::uint32_t> indices;
};

struct TrackSolid {
  std::array<SolidPart, 3> parts{SolidPart{"rails", {}, {}, {}}, SolidPart{"spine", {}, {}, {}}, SolidPart{"ties", {}, {}, {}}};
  std::vector<glm::vec3> centre_line;  // of a closed track it ends where it starts; empty without segments
};

inline constexpr double kLineTolerance = 0.001;  // m, between the centre line and the curve (but at most 1000 chords a segment)

// What sim::sweep_track gives for every segment, in order.
TrackSolid track_solid(const world::Document& document);

}  // namespace coaster::exchange
