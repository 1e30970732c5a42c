#include "sim/ride/simulated_ride.h"

#include <algorithm>
#include <cmath>

namespace coaster::sim {
namespace {

// Between two moments with speeds v0 and v1, and accelerations a0 and a1, `way` m apart: the cubic of v^2 at `gone` m.
PassingState between(double v0, double a0, double v1, double a1, double way, double gone) {
  if (way == 0) return {v1, a1};
  const double u = gone / way, u_left = 1 - u;
  const double square_gained = v1 * v1 - v0 * v0, slope_before = 2 * a0 * way, slope_after = 2 * a1 * way;  // m^2/s^2
  const double square =
      v0 * v0 + u * u * (3 - 2 * u) * square_gained + u * u_left * u_left * slope_before - u * u * u_left * slope_after;
  const double slope =
      6 * u * u_left * square_gained + u_left * (1 - 3 * u) * slope_before + u * (3 * u - 2) * slope_after;
  return {std::copysign(std::sqrt(std::max(square, 0.0)), v0 + v1), 0.5 * slope / way};
}

}  // namespace

bool runs_backwards(const SimulatedRide& ride) {
  double most = 0, least = 0;
  for (const RideSample& sample : ride.samples)
    most = std::max(most, sample.travelled), least = std::min(least, sample.travelled);
  return -least > most;
}

PassingLookup::PassingLookup(const SimulatedRide& ride) : ride_(ride), backwards_(runs_backwards(ride)) {
  furthest_.reserve(ride.samples.size());
  for (const RideSample& sample : ride.samples) {
    const double far = backwards_ ? -sample.travelled : sample.travelled;
    furthest_.push_back(furthest_.empty() ? far : std::max(far, furthest_.back()));
  }
}

std::optional<PassingState> PassingLookup::at(double distance, double back) const {
  const double sign = backwards_ ? -1 : 1;
  double way = sign * (distance + back - ride_.start.front);
  if (ride_.closed && way < 0) way += ride_.track_length;
  if (ride_.closed && way > ride_.track_length) way -= ride_.track_length;
  const auto found = std::lower_bound(furthest_.begin(), furthest_.end(), way);
  if (way < 0 || found == furthest_.end()) return std::nullopt;
  const auto i = static_cast<std::size_t>(found - furthest_.begin());
  const RideSample& to = ride_.samples[i];
  if (i == 0) return PassingState{to.speed, to.acceleration};
  const RideSample& from = ride_.samples[i - 1];
  RideSwitch before{i - 1, from.travelled, from.speed, from.acceleration, from.acceleration},
      after{i, to.travelled, to.speed, to.acceleration, to.acceleration};
  auto next = std::ranges::lower_bound(ride_.switches, i, {}, &RideSwitch::sample);
  for (; next != ride_.switches.end() && next->sample == i; ++next) {
    if (sign * next->travelled >= way) {
      after = *next;
      break;
    }
    before = *next;
  }
  return between(before.speed, before.acceleration_after, after.speed, after.acceleration_before,
                 after.travelled - before.travelled, sign * way - before.travelled);
}

}  // namespace coaster::sim
