#include "sim/study/advice.h"

#include <algorithm>
#include <cmath>

#include "world/evaluation.h"
#include "world/topology.h"

namespace coaster::sim {
namespace {

// Returns by how much a ride exceeds the envelope near the span: g times seconds of excess of all spans of its car and
// axis that overlap its stretch of track.
double excess(const Ghost& ghost, const Envelope& envelope, const RedSpan& span) {
  constexpr double kNear = 10;  // m on each side
  const auto touches = [&](const RedSpan& other) {
    if (other.car != span.car || other.axis != span.axis) return false;
    return other.from_distance <= span.to_distance + kNear && other.to_distance >= span.from_distance - kNear;
  };
  double sum = 0;
  for (const RedSpan& other : red_spans(ghost, envelope))
    if (touches(other)) sum += (other.worst - other.allowed) * (1.0 + other.to - other.from);
  return sum;
}

class Trials {
 public:
  Trials(const world::Document& document, world::Entity cart) : original_(document), document_(document), cart_(cart) {
    derive(document_, settings_, {}, derived_);
  }
  const Derived& derived() const { return derived_; }
  // Of the present document.
  double excess_of(const Envelope& envelope, const RedSpan& span) {
    document_ = original_;
    return excess_now(envelope, span);
  }
  // With a knot moved as the editor moves it: automatic joints nearby follow.
  double excess_with(world::Entity knot, glm::vec3 to, const Envelope& envelope, const RedSpan& span) {
    document_ = original_;
    document_.entities.get<world::Knot>(knot).position = to;
    world::settle_joints(document_);
    return excess_now(envelope, span);
  }

 private:
  double excess_now(const Envelope& envelope, const RedSpan& span) {
    derive(document_, settings_, {}, derived_);
    const Ghost* const ghost = memo_.ride(document_, derived_, cart_);
    return ghost ? excess(*ghost, envelope, span) : 0.0;
  }
  static world::Settings coarse() {
    world::Settings settings;
    settings.evaluation->steps = 1;  // polylines are not needed
    return settings;
  }
  const world::Document& original_;
  world::Document document_;
  world::Entity cart_;
  world::Settings settings_ = coarse();
  Derived derived_;
  GhostMemo memo_;
};

}  // namespace

std::optional<Advice> advise(const world::Document& document, world::Entity cart, const Envelope& envelope,
                             const RedSpan& span) {
  Trials trials(document, cart);
  if (trials.derived().order.empty()) return std::nullopt;
  const double before = trials.excess_of(envelope, span);
  const int count = static_cast<int>(document.track.knots.size());
  const int first = static_cast<int>(place_at(trials.derived(), span.from_distance).index) - kAdviceReach;
  int last = static_cast<int>(place_at(trials.derived(), span.to_distance).index) + 1 + kAdviceReach;
  if (last < first) last += count;
  std::optional<Advice> best;
  for (int n = first; n <= std::min(last, first + count - 1); ++n) {
    if (!document.track.closed && (n < 0 || n >= count)) continue;
    const world::Entity entity = document.track.knots[static_cast<std::size_t>(((n % count) + count) % count)];
    const glm::vec3 at = world::knot(document, entity).position;
    for (int axis = 0; axis < 3; ++axis)
      for (const float sign : {1.0f, -1.0f}) {
        glm::vec3 direction(0);
        direction[axis] = sign;
        const double after = trials.excess_with(entity, at + kAdviceStep * direction, envelope, span);
        if (after < before && (!best || after < best->after)) best = Advice{entity, direction, before, after};
      }
  }
  return best;
}

}  // namespace coaster::sim
