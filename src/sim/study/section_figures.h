// What each section of the track is and what is felt on it: length, heights, and of a ride speeds and g.
#pragma once

#include <optional>
#include <vector>

#include "sim/study/seat.h"
#include "world/sections.h"

namespace coaster::sim {

struct SectionFigures {
  world::SectionRun run;
  double length = 0;                   // m
  double start = 0, end = 0, top = 0;  // m, heights of the curve: at both ends, and the largest
  // Of a seat's riders when they first come to a place; nothing where they do not. Speeds at both ends (m/s); the
  // largest and the least vertical g; the largest lateral g, absolute.
  std::optional<double> speed_in, speed_out, g_most, g_least, g_side;
};

// In the track's order.
struct SectionTable {
  std::vector<SectionFigures> rows;
  std::uint64_t serial = 0;  // a new one for each change
  const SectionFigures& of(const world::SectionRun& run) const;
};

// Returns the figures of all sections. `curves`: by place, of the seat; null without a ride. Linear in segments and
// points of the curves.
std::vector<SectionFigures> section_figures(const world::Document& document, const Derived& derived,
                                            const SeatCurves* curves);

}  // namespace coaster::sim
