// What stands around a station besides its platforms: a roof on columns, gates, a board with the track's name, and a
// queue with a plaza and a path. Decoration: nothing depends on it.
#pragma once

#include <cstdint>
#include <string_view>

#include "sim/ground/ground.h"
#include "sim/shape/derived_track.h"
#include "sim/solids/mesh.h"

namespace coaster::sim {

// Returns the solids of all stations, in world space (m): of those that are level enough to walk on and at least 6 m
// long. The board shows the first kMostLetters of `name` in capitals; other characters than Latin letters, digits and
// common marks are blanks.
inline constexpr std::size_t kMostLetters = 24;
struct StationBuildings {
  Mesh mesh;
  std::uint64_t build = 0;  // a new number when the solids change
};
Mesh station_mesh(const DerivedTrack& derived, const Ground& ground, std::string_view name);

}  // namespace coaster::sim
