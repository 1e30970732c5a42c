// Suggests a knot to move, and its direction, to reduce an overload: finite differences over whole rides.
#pragma once

#include <optional>

#include "sim/study/ratings.h"

namespace coaster::sim {

struct KnotMoveAdvice {
  world::Entity knot;
  glm::vec3 direction{0};  // unit, along an axis of the world
  // g over the limit, summed over the overloads of that kind, now and after a move of kAdviceStep.
  double before = 0, after = 0;
};
inline constexpr float kAdviceStep = 0.25f;  // m
inline constexpr int kAdviceReach = 3;       // knots to try on each side of the span

// Tries the knots from kAdviceReach before the span to as many after it, each along +-x, +-y and +-z. Returns the move
// that reduces the span's excess most; nothing if none does. Cost: about 40 rides, 2 ms each for a circuit of 1 km.
std::optional<KnotMoveAdvice> advise(const world::Document& document, world::Entity cart,
                                     const ForceLimitCurves& envelope, const Overload& span);

}  // namespace coaster::sim
