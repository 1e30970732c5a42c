#include "sim/ride/start_speed.h"

#include <algorithm>

#include "sim/ride/ghost.h"
#include "world/evaluation.h"

namespace coaster::sim {
namespace {

constexpr double kSpare = 1;  // m/s more than the least that completes the ride

bool completes(const Ghost& ghost) {
  return ghost.lap || (ghost.end == world::FailureKind::off_end && ghost.samples.back().speed > 0);
}

}  // namespace

std::optional<double> completing_speed(world::Document document) {
  const world::Entity cart = world::first_cart(document);
  if (!cart.valid()) return std::nullopt;
  world::Settings settings;
  settings.evaluation->steps = 1;  // polylines are not needed
  Derived derived;
  derive(document, settings, {}, derived);
  GhostMemo memo;
  const auto enough = [&](int speed) {
    document.start_speed = speed;
    const Ghost* const ghost = memo.ride(document, derived, cart);
    return ghost != nullptr && completes(*ghost);
  };
  int low = 0, high = static_cast<int>(world::kMaxSpeed);  // too slow, fast enough
  if (!enough(high)) return std::nullopt;
  while (high > low + 1) {
    const int middle = (low + high) / 2;
    (enough(middle) ? high : low) = middle;
  }
  return std::min(high + kSpare, world::kMaxSpeed);
}

}  // namespace coaster::sim
