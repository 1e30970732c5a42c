// Measures and prints a ride.
#include "app/ride_summary.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "exchange/own/json_output.h"
#include "sim/ride/ride.h"

namespace coaster::app {
namespace {

double height_of(const edit::Session& session, const world::TrainMotion& cart) {
  return sim::rail_point(session.derived.shape(cart.segment), cart.s).height;
}

std::string end_of_ride(const edit::Session& session, const RideSummary& summary) {
  if (const std::string failure = edit::failure_text(session); !failure.empty()) return failure;
  const world::TrainMotion& cart = session.motion.carts.items()[0];
  if (cart.laps != 0) return "The train completed the lap.";
  if (session.motion.state == world::RideState::ended) return "The train reached the end of the track.";
  return fmt::format("Stopped after {:.0f} s at {:.1f} m ({:.1f} m/s), before the end of the ride.",
                     static_cast<double>(summary.ticks) * world::kTick, cart.travelled, cart.speed);
}

}  // namespace

RideSummary begin_summary(const edit::Session& session) {
  RideSummary summary;
  summary.name = session.document.name;
  summary.knots = session.document.track.knots.size();
  summary.segments = session.document.track.segments.size();
  summary.closed = session.document.track.closed;
  summary.length = session.derived.length;
  summary.cutoff = edit::force_limits(session).cutoff;
  if (session.motion.carts.size() == 0) return summary;
  summary.highest = summary.lowest = height_of(session, session.motion.carts.items()[0]);
  return summary;
}

void measure(const edit::Session& session, RideSummary& summary) {
  ++summary.ticks;
  if (session.motion.carts.size() == 0) return;
  const world::TrainMotion& cart = session.motion.carts.items()[0];
  const double height = height_of(session, cart);
  const world::Entity train = session.motion.carts.entities()[0];
  summary.laps = cart.laps;
  summary.distance = cart.travelled;
  summary.top_speed = std::max(summary.top_speed, std::abs(cart.speed));
  summary.highest = std::max(summary.highest, height);
  summary.lowest = std::min(summary.lowest, height);
  summary.worst_drift =
      std::max(summary.worst_drift, sim::energy_drift(session.document, session.derived, train, cart));
}

void finish_summary(edit::Session& session, RideSummary& summary) {
  summary.end = end_of_ride(session, summary);
  const edit::SessionFindings find(session);
  const sim::SimulatedRide* const ride = find.ride();
  if (ride == nullptr) return;
  const sim::Ratings felt = sim::rate(*ride, find.tables(), summary.cutoff);
  summary.most_up = felt.up_most.value, summary.least_up = felt.up_least.value;
  summary.most_side = felt.side_most.value;
}

std::string to_text(const RideSummary& s) {
  return fmt::format(
      "{}: {} knots, {} segments, {}, {:.2f} m\n"
      "rode {:.2f} m in {:.2f} s, {} laps\n"
      "top speed {:.2f} m/s, heights {:.2f}..{:.2f} m\n"
      "felt g, low-passed at {:.3g} Hz: vertical {:.2f}..{:.2f}, lateral at most {:.2f}\n"
      "energy drift at most {:.1e}\n"
      "{}\n",
      s.name, s.knots, s.segments, s.closed ? "closed" : "open", s.length, s.distance,
      static_cast<double>(s.ticks) * world::kTick, s.laps, s.top_speed, s.lowest, s.highest, s.cutoff, s.least_up,
      s.most_up, s.most_side, s.worst_drift, s.end);
}

std::string to_json(const RideSummary& s) {
  return exchange::json_members({{"name", s.name},
                                 {"knots", static_cast<std::int64_t>(s.knots)},
                                 {"segments", static_cast<std::int64_t>(s.segments)},
                                 {"closed", s.closed},
                                 {"length_m", s.length},
                                 {"time_s", static_cast<double>(s.ticks) * world::kTick},
                                 {"laps", s.laps},
                                 {"distance_m", s.distance},
                                 {"top_speed_m_s", s.top_speed},
                                 {"highest_m", s.highest},
                                 {"lowest_m", s.lowest},
                                 {"most_up_g", s.most_up},
                                 {"least_up_g", s.least_up},
                                 {"most_side_g", s.most_side},
                                 {"energy_drift", s.worst_drift},
                                 {"end", s.end}});
}

}  // namespace coaster::app
