#include "sim/study/overload_advice.h"

#include <algorithm>

#include "world/evaluation_settings.h"
#include "world/topology.h"

namespace coaster::sim {
namespace {

// Returns by how much a ride exceeds the envelope near the span: g times seconds of excess of all spans of its car and
// axis that overlap its part of the track.
double excess(const SimulatedRide& simulated, const ForceLimitCurves& envelope, const Overload& span) {
  constexpr double kNear = 10;  // m on each side
  const auto touches = [&](const Overload& other) {
    if (other.car != span.car || other.axis != span.axis) return false;
    return other.from_distance <= span.to_distance + kNear && other.to_distance >= span.from_distance - kNear;
  };
  double sum = 0;
  for (const Overload& other : red_spans(simulated, envelope))
    if (touches(other)) sum += (other.worst - other.allowed) * (1.0 + other.to - other.from);
  return sum;
}

}  // namespace

std::optional<KnotMoveAdvice> advise(const world::Document& document, world::Entity cart,
                                     const ForceLimitCurves& envelope, const Overload& span) {
  if (document.track.segments.empty()) return std::nullopt;
  world::Settings settings;
  settings.evaluation->steps = 1;  // polylines are not needed
  DerivedTrack derived;
  RideCache cache;
  const auto excess_of = [&](const world::Document& tried) {
    derive(tried, settings, {}, derived);
    const SimulatedRide* const simulated = cache.ride(tried, derived, cart);
    return simulated ? excess(*simulated, envelope, span) : 0.0;
  };
  const double before = excess_of(document);
  const int count = static_cast<int>(document.track.knots.size());
  const int first = static_cast<int>(place_at(derived, span.from_distance).index) - kAdviceReach;
  int last = static_cast<int>(place_at(derived, span.to_distance).index) + 1 + kAdviceReach;
  if (last < first) last += count;
  std::optional<KnotMoveAdvice> best;
  for (int n = first; n <= std::min(last, first + count - 1); ++n) {
    if (!document.track.closed && (n < 0 || n >= count)) continue;
    const world::Entity entity = document.track.knots[static_cast<std::size_t>(((n % count) + count) % count)];
    for (int axis = 0; axis < 3; ++axis)
      for (const float sign : {1.0f, -1.0f}) {
        glm::vec3 direction(0);
        direction[axis] = sign;
        world::Document tried = document;
        tried.entities.get<world::Knot>(entity).position += kAdviceStep * direction;
        world::settle_joints(tried);  // as after a move by the user
        const double after = excess_of(tried);
        if (after < before && (!best || after < best->after)) best = KnotMoveAdvice{entity, direction, before, after};
      }
  }
  return best;
}

}  // namespace coaster::sim
