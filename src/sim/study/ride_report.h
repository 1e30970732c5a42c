// The extreme values of the ride report, for its text (ratings.h) and its JSON.
#pragma once

#include <span>
#include <vector>

#include "sim/study/ratings.h"

namespace coaster::sim {

// An extreme value of the report: "top speed", in m/s.
struct Figure {
  const char *name, *unit;
  Extreme at;
};
// Returns the report's extreme values, in its order; `riders`: all cars, first to last.
std::vector<Figure> report_figures(const Ratings& ratings, std::span<const Rider> riders);

}  // namespace coaster::sim
