// Figures of each section of the track: length, heights, and of a ride the speeds and g.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "sim/study/riders.h"
#include "world/sections.h"

namespace coaster::sim {

struct SectionFigures {
  world::SectionRun run;
  double length = 0;                   // m
  double start = 0, end = 0, top = 0;  // m, heights of the curve: at both ends, and the largest
  // For a seat's riders at their first pass; nothing where they do not arrive. Speeds at both ends (m/s); the largest
  // and the least vertical g; the largest lateral g, absolute.
  std::optional<double> speed_in, speed_out, g_most, g_least, g_side;
};

// The sections in track order.
struct SectionTable {
  std::vector<SectionFigures> rows;
  std::uint64_t serial = 0;  // new for each change
  const SectionFigures& of(const world::SectionRun& run) const;
};

// Returns the figures of all sections. `riders`: of the seat; none without a ride. Linear in segments and entries.
std::vector<SectionFigures> section_figures(const world::Document& document, const DerivedTrack& derived,
                                            std::span<const Rider> riders);

}  // namespace coaster::sim
