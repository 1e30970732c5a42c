#include "sim/study/colour_values.h"

#include <algorithm>
#include <cmath>

#include "sim/study/evaluator_benchmark.h"
#include "sim/study/riders.h"
#include "world/evaluation_settings.h"
#include "world/laboratory_settings.h"

namespace coaster::sim {
namespace {

using world::Colouring;

constexpr double kMostCurvature = 1e3;  // 1/m: unbounded towards a cusp

double place(const SegmentShape& shape, int j) { return shape.arc.length() * j / (kValuesPerSegment - 1); }

float height_at(const SegmentShape& shape, int j) {
  return static_cast<float>(curve::point(shape.key.cubic, shape.arc.parameter(place(shape, j))).y);
}
float curvature_at(const SegmentShape& shape, int j) {
  const auto value = curve::curvature_if_any(shape.key.cubic, shape.arc.parameter(place(shape, j)));
  return value ? static_cast<float>(std::min(*value, kMostCurvature)) : kUnknownValue;
}

// Fills in millimetres: each position takes the largest of its nearest vertices, or interpolates between two if there
// are few.
void fill_error(const SegmentShape& shape, const world::Settings& settings, std::span<float> out) {
  const auto& profile =
      error_profile(shape.curve, base::row_of(settings.evaluation->evaluator), settings.evaluation->steps);
  const double length = shape.arc.length(), step = length / (kValuesPerSegment - 1);
  std::fill(out.begin(), out.end(), 0.0f);
  double last = 0, before = 0;
  for (const ErrorSample& sample : profile) {
    const double s = shape.arc.distance(sample.t);
    const int from = step > 0 ? static_cast<int>(std::ceil(last / step - 0.5)) : 0,
              to = step > 0 ? static_cast<int>(std::floor(s / step + 0.5)) : 0;
    for (int j = std::max(from, 0); j <= std::min(to, kValuesPerSegment - 1); ++j) {
      float& value = out[static_cast<std::size_t>(j)];
      value = std::max(value, static_cast<float>(std::max(sample.mm, before)));
    }
    last = s, before = sample.mm;
  }
}

// Returns the value; lateral, backward and roll values are absolute.
double value_of(const Rider& rider, std::size_t entry, Colouring colouring) {
  if (colouring == Colouring::up_stop) return wheel_loads(*rider.simulated, entry, rider.car).of(WheelSet::car).up_stop;
  const double value = rider.value(entry, *ride_value_of(colouring));
  return colouring == Colouring::vertical || colouring == Colouring::longitudinal ? value : std::abs(value);
}

// Distributes the ride's values over the positions that the car passes.
class ValueSpreader {
 public:
  ValueSpreader(const DerivedTrack& derived, double rest, std::vector<float>& out)
      : rest_(rest), length_(derived.length), closed_(derived.closed), out_(out) {
    places_.reserve(out.size());
    for (std::size_t i = 0; i < derived.order.size(); ++i)
      for (int j = 0; j < kValuesPerSegment; ++j)
        places_.push_back(
            std::lerp(derived.starts[i], derived.starts[i + 1], static_cast<double>(j) / (kValuesPerSegment - 1)));
  }
  // Adds the values from distance a with value va to distance b with value vb.
  void add(double a, double va, double b, double vb) {
    if (a > b) std::swap(a, b), std::swap(va, vb);
    const double turn = closed_ && length_ > 0 ? length_ * std::floor(a / length_) : 0.0;
    fill(a - turn, va, b - turn, vb);
    if (closed_ && b - turn >= length_) fill(a - turn - length_, va, b - turn - length_, vb);
  }

 private:
  void fill(double a, double va, double b, double vb) {
    for (auto at = std::lower_bound(places_.begin(), places_.end(), a); at != places_.end() && *at <= b; ++at) {
      const double value = b > a ? std::lerp(va, vb, (*at - a) / (b - a)) : va;
      float& old = out_[static_cast<std::size_t>(at - places_.begin())];
      if (old == kUnknownValue || std::abs(value - rest_) > std::abs(static_cast<double>(old) - rest_))
        old = static_cast<float>(value);
    }
  }
  double rest_, length_;
  bool closed_;
  std::vector<double> places_;
  std::vector<float>& out_;
};

void fill_ride(const DerivedTrack& derived, const Rider& rider, Colouring colouring, std::vector<float>& out) {
  ValueSpreader spread(derived, colouring == Colouring::vertical ? 1.0 : 0.0, out);
  for (std::size_t k = 0; k + 1 < rider.entries(); ++k)
    spread.add(rider.place(k), value_of(rider, k, colouring), rider.place(k + 1), value_of(rider, k + 1, colouring));
}

// Rounds to multiples of 1, 2 or 5 times a power of ten, about five of them from low to high: the legend does not
// jitter during a drag.
void round_range(TrackValues& values) {
  double low = 1e300, high = -1e300;
  for (const float value : values.values)
    if (value != kUnknownValue)
      low = std::min(low, static_cast<double>(value)), high = std::max(high, static_cast<double>(value));
  if (low > high) low = 0, high = 1;
  if (low > 0 && low < 0.5 * high) low = 0;
  const bool fine = values.colouring == Colouring::curvature || values.colouring == Colouring::error;
  const double least = fine ? 1e-6 : 0.5;  // m/s, g, kN or m
  const double span = std::max(high - low, std::max(least, 1e-3 * std::max(std::abs(low), std::abs(high))));
  const double power = std::pow(10.0, std::floor(std::log10(span / 5)));
  const double part = span / 5 / power;
  const double step = power * (part > 5 ? 10 : part > 2 ? 5 : part > 1 ? 2 : 1);
  values.low = step * std::floor(low / step + 1e-9);
  values.high = step * std::ceil(high / step - 1e-9);
  if (!(values.low < values.high)) values.high = values.low + step;
}

}  // namespace

void TrackValueCache::fill_segments(const DerivedTrack& derived, const world::Settings& settings) {
  for (std::size_t i = 0; i < derived.order.size(); ++i) {
    const SegmentShape& shape = derived.shape_at(i);
    Entry& entry = entries_.obtain(derived.order[i]);
    if (entry.build != shape.shape_build) {
      entry.build = shape.shape_build;
      if (settings.lab->colouring == Colouring::error) fill_error(shape, settings, entry.samples);
      else
        for (int j = 0; j < kValuesPerSegment; ++j)
          entry.samples[static_cast<std::size_t>(j)] =
              settings.lab->colouring == Colouring::height ? height_at(shape, j) : curvature_at(shape, j);
    }
    std::copy(entry.samples.begin(), entry.samples.end(),
              result_.values.begin() + static_cast<std::ptrdiff_t>(i * kValuesPerSegment));
  }
}

std::optional<RideValue> ride_value_of(Colouring colouring) {
  switch (colouring) {
    case Colouring::speed: return RideValue::speed;
    case Colouring::vertical: return RideValue::vertical;
    case Colouring::lateral: return RideValue::lateral;
    case Colouring::longitudinal: return RideValue::longitudinal;
    case Colouring::jerk: return RideValue::jerk;
    case Colouring::roll_rate: return RideValue::roll_rate;
    case Colouring::roll_acceleration: return RideValue::roll_acceleration;
    default: return std::nullopt;
  }
}

const TrackValues& TrackValueCache::update(const DerivedTrack& derived, const world::Settings& settings,
                                           const std::optional<Rider>& rider) {
  const Colouring colouring = settings.lab->colouring;
  const bool of_ride = base::row_of(colouring).of_ride, of_evaluator = colouring == Colouring::error;
  const Key key{colouring,
                of_ride && rider ? rider->simulated->serial : 0,
                of_ride && rider ? rider->cutoff : 0.0,
                derived.last_build,
                of_evaluator ? settings.evaluation->evaluator : curve::EvaluatorId{},
                of_evaluator ? settings.evaluation->steps : 0};
  if (key == key_ && order_ == derived.order) return result_;
  if (key.colouring != key_.colouring || key.evaluator != key_.evaluator || key.steps != key_.steps ||
      derived.order.size() < order_.size())
    entries_ = {};
  key_ = key;
  order_ = derived.order;
  result_.colouring = colouring;
  result_.values.clear();
  if (colouring == Colouring::plain) return result_;
  result_.values.assign(derived.order.size() * kValuesPerSegment, kUnknownValue);
  if (!of_ride) fill_segments(derived, settings);
  else if (rider) fill_ride(derived, *rider, colouring, result_.values);
  round_range(result_);
  return result_;
}

}  // namespace coaster::sim
