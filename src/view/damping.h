// Values that follow others without overshoot: critical damping, solved exactly for a constant target during a step, so
// that two steps of one tick equal one step of two.
#pragma once

#include <cmath>

#include <glm/glm.hpp>

namespace coaster::view {

// x'' = -2 k x' - k^2 (x - target), k = 2 / lag. Lags a steadily moving target by `lag` seconds; lag 0 is the target
// itself.
template <class T>
struct Damped {
  T value{}, rate{};

  void approach(const T& target, double lag, double dt) {
    if (!(lag > 0)) {
      value = target, rate = T{};
      return;
    }
    const double k = 2.0 / lag, decay = std::exp(-k * dt);
    const T off = value - target, push = rate + k * off;
    value = target + (off + push * dt) * decay;
    rate = (rate - k * dt * push) * decay;
  }
  void settle(const T& target) { value = target, rate = T{}; }
};

}  // namespace coaster::view
