// The whole track as triangles and a line, for shape formats. Private to this room.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include "world/document.h"

namespace coaster::exchange {

// One part of the track: triangles, counter-clockwise seen from outside; may be empty.
struct SolidPart {
  std::string_view name;
  glm::vec3 colour{0};               // linear red, green, blue
  std::vector<glm::vec3> positions;  // m
  std::vector<glm::vec3> normals;    // unit, one per position
  std::vector<std::uint32_t> indices;
};

inline constexpr glm::vec3 kLineColour{1, 0.8f, 0};  // of the centre line

struct TrackSolid {
  std::array<SolidPart, 6> parts{
      SolidPart{"rails", {0.75f, 0.1f, 0.08f}},    SolidPart{"spine", {0.2f, 0.25f, 0.35f}},
      SolidPart{"ties", {0.45f, 0.47f, 0.5f}},     SolidPart{"equipment", {0.3f, 0.33f, 0.36f}},
      SolidPart{"supports", {0.8f, 0.81f, 0.83f}}, SolidPart{"concrete", {0.46f, 0.48f, 0.46f}}};
  std::vector<glm::vec3> centre_line;  // a closed track's line ends at its start; empty without segments
};

inline constexpr double kLineTolerance =
    0.001;  // m, between the centre line and the rails (with at most 1000 chords per segment)

// Builds the solids of every segment, in order: the swept track, its equipment, its supports. Rails and spine are
// capped only at the ends of an open track.
TrackSolid track_solid(const world::Document& document);

}  // namespace coaster::exchange
