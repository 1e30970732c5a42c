// Where track runs below the land: samples of the track, and which of them lie in tunnels.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/glm.hpp>

#include "sim/ground/land.h"
#include "sim/shape/derived_track.h"

namespace coaster::sim {

// The room about the middle of the rails that earth leaves to trains and track, m.
struct TrackRoom {
  double below = 2, above = 2.1, beside = 1.6;
  double tube = 2.5, lift = 0.45;  // radius of tunnels, and the height of their middle along the track's `up`
  bool operator==(const TrackRoom&) const = default;
};

// A point of the rails; a track has one about every kSampleSpacing metres.
inline constexpr double kSampleSpacing = 1.5;
struct TrackSample {
  glm::dvec3 at{0};  // m
  glm::dvec3 forward{1, 0, 0}, up{0, 1, 0};
  double distance = 0;      // m along the track
  double cover = 0;         // m of earth above the rails, of the land as people left it; negative: none
  std::size_t segment = 0;  // index into the track's order
  world::Earthwork wish{};
  bool station = false, tunnel = false;
};

// A stretch of track within earth, by index of its samples: first..last, which passes the track's start on a closed one
// where last < first.
struct Tunnel {
  std::size_t first = 0, last = 0;
  double from = 0, length = 0;  // m along the track
};

// Returns the samples of one segment; `fraction` of the way between neighbours. Their `distance` is within the segment.
std::vector<TrackSample> samples_of(const SegmentShape& shape, const Land& land);

// Marks the samples that lie in tunnels and returns the tunnels, in the track's order. Where the wish is automatic, a
// tunnel is at least kLeastTunnel long and has at least kLeastCover of earth over the room of a train.
inline constexpr double kLeastTunnel = 15, kLeastCover = 2.4;  // m
std::vector<Tunnel> find_tunnels(std::vector<TrackSample>& samples, const TrackRoom& room, bool closed);

}  // namespace coaster::sim
