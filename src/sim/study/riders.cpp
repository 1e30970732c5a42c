#include "sim/study/riders.h"

#include <algorithm>
#include <cmath>

#include "base/check.h"
#include "base/portable_math.h"
#include "sim/study/envelope.h"

namespace coaster::sim {
namespace {

constexpr double kRate = static_cast<double>(world::kTicksPerSecond) / kForceEvery;  // entries per second
constexpr double kDegrees = 180.0 / base::kPi;

double magnitude(const Force& force) {
  const double up = force.up, left = force.left, forward = force.forward;
  return std::sqrt(up * up + left * left + forward * forward);
}

void fill_jerk(const Ghost& ghost, int car, float Force::*axis, double cutoff, std::vector<RiderSample>& samples) {
  const std::vector<float> felt = low_passed_g(ghost, car, axis, cutoff);
  for (std::size_t k = 0; k < felt.size(); ++k) {
    const std::size_t before = k > 0 ? k - 1 : k, after = std::min(k + 1, felt.size() - 1);
    if (after == before) continue;
    samples[k].jerk.*axis =
        (felt[after] - felt[before]) * static_cast<float>(kRate / static_cast<double>(after - before));
  }
}

void fill_roll_and_height(const Ghost& ghost, int car, const RailTables& tables, const Derived& derived,
                          std::vector<RiderSample>& samples) {
  std::size_t hint = 0;
  for (std::size_t k = 0; k < samples.size(); ++k) {
    const GhostSample& moving = ghost.samples[ghost.sample_of(k)];
    const double distance = ghost.distance(ghost.sample_of(k), car), s = tables.locate(distance, hint);
    samples[k].height = static_cast<float>(rail_at(tables.segment(hint), s).height);
    if (!ghost.closed && !(distance >= 0 && distance <= ghost.track_length)) continue;  // on the straight continuation
    const SegmentShape& shape = derived.shape_at(hint);
    const double spin = shape.roll.spin(s), v = moving.speed;
    samples[k].roll_rate = static_cast<float>(kDegrees * spin * v);
    samples[k].roll_acceleration =
        static_cast<float>(kDegrees * (shape.roll.slope(s) * v * v + spin * moving.acceleration));
  }
}

}  // namespace

double Rider::value(std::size_t k, RideValue value) const {
  const Force& force = ghost->forces[k * static_cast<std::size_t>(ghost->start.cars) + static_cast<std::size_t>(car)];
  switch (value) {
    case RideValue::vertical: return force.up;
    case RideValue::lateral: return force.left;
    case RideValue::longitudinal: return force.forward;
    case RideValue::jerk: return magnitude(samples[k].jerk);
    case RideValue::jerk_up: return samples[k].jerk.up;
    case RideValue::jerk_side: return samples[k].jerk.left;
    case RideValue::jerk_forward: return samples[k].jerk.forward;
    case RideValue::roll_rate: return samples[k].roll_rate;
    case RideValue::roll_acceleration: return samples[k].roll_acceleration;
    case RideValue::speed: return ghost->samples[ghost->sample_of(k)].speed;
    case RideValue::height: return samples[k].height;
  }
  return 0;
}

void Riders::update(const Ghost& ghost, const RailTables& tables, const Derived& derived, double cutoff,
                    CarRange cars) {
  if (serial_ != ghost.serial || cutoff_ != cutoff) samples_.clear();
  ghost_ = &ghost, serial_ = ghost.serial, cutoff_ = cutoff;
  samples_.resize(static_cast<std::size_t>(ghost.start.cars));
  for (int car = cars.first; car <= cars.last; ++car) {
    std::vector<RiderSample>& samples = samples_[static_cast<std::size_t>(car)];
    if (!samples.empty()) continue;
    samples.resize(Rider{&ghost}.entries());
    for (float Force::*const axis : {&Force::up, &Force::left, &Force::forward})
      fill_jerk(ghost, car, axis, cutoff, samples);
    fill_roll_and_height(ghost, car, tables, derived, samples);
  }
}

Rider Riders::car(int index) const {
  COASTER_CHECK(ghost_ != nullptr && index >= 0 && static_cast<std::size_t>(index) < samples_.size(),
                "the train has this car");
  return {ghost_, index, samples_[static_cast<std::size_t>(index)], cutoff_};
}

std::vector<Rider> Riders::cars(CarRange range) const {
  std::vector<Rider> riders;
  for (int i = range.first; i <= range.last; ++i) riders.push_back(car(i));
  return riders;
}

}  // namespace coaster::sim
