// The figures of a ride: measured tick by tick, and what riders feel during the whole of it.
#pragma once

#include <string>

#include "edit/session/session.h"

namespace coaster::app {

inline constexpr std::int64_t kMostRideTicks = 120 * world::kTicksPerSecond;  // limit of a ride without a window

struct RideSummary {
  std::string name;
  std::size_t knots = 0, segments = 0;
  bool closed = false;
  double length = 0;  // m
  std::int64_t ticks = 0, laps = 0;
  double distance = 0;             // m, signed
  double top_speed = 0;            // m/s
  double highest = 0, lowest = 0;  // m
  // Felt g of the whole simulated ride and of all cars after the force limits' low-pass, as in the report. `cutoff` is
  // that of the low-pass, Hz.
  double most_up = 1, least_up = 1, most_side = 0, cutoff = 0;
  double worst_drift = 0;                       // relative drift of the energy
  std::string end = "The track has no train.";  // why the ride stopped
};

RideSummary begin_summary(const edit::Session& session);
// Adds the state after a tick.
void measure(const edit::Session& session, RideSummary& summary);

// Adds what riders feel, and why the ride of the first train has stopped, or, if it is still running, that it was
// stopped after the summary's time. There must be a train.
void finish_summary(edit::Session& session, RideSummary& summary);

std::string to_text(const RideSummary& summary);
std::string to_json(const RideSummary& summary);

}  // namespace coaster::app
