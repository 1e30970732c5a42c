#include "sim/study/force_limits.h"

#include <algorithm>
#include <cmath>

#include "base/portable_math.h"
#include "world/evaluation_settings.h"
#include "world/topology.h"

namespace coaster::sim {
namespace {

// A second-order section, by the bilinear transform of 1 / (p^2 + p/q + 1) with the cutoff preserved.
struct FilterSection {
  double b, a1, a2;  // (b, 2b, b) over (1, a1, a2)
  FilterSection(double rate, double cutoff, double q) {
    const double k = std::tan(base::kPi * std::min(cutoff, 0.45 * rate) / rate), norm = 1.0 / (1.0 + k / q + k * k);
    b = k * k * norm, a1 = 2.0 * (k * k - 1.0) * norm, a2 = (1.0 - k / q + k * k) * norm;
  }
  void run(std::span<float> values) const {
    double x1 = values.front(), x2 = x1, y1 = x1, y2 = x1;
    for (float& value : values) {
      const double x = value, y = b * (x + 2.0 * x1 + x2) - a1 * y1 - a2 * y2;
      x2 = x1, x1 = x, y2 = y1, y1 = y;
      value = static_cast<float>(y);
    }
  }
};

// Returns the seat's axis of a limit.
float FeltAcceleration::*seat_axis(ForceAxis axis) {
  switch (axis) {
    case ForceAxis::down:
    case ForceAxis::lift: return &FeltAcceleration::up;
    case ForceAxis::side: return &FeltAcceleration::left;
    case ForceAxis::forward:
    case ForceAxis::back: return &FeltAcceleration::forward;
  }
  return &FeltAcceleration::up;
}

// For each entry the longest run around it with no value below its own: [first, last].
struct LongestRun {
  std::size_t first, last;
};
std::vector<LongestRun> runs_at_least(std::span<const float> values) {
  std::vector<LongestRun> runs(values.size());
  std::vector<std::size_t> open;  // entries whose run is still open, values ascending
  for (std::size_t i = 0; i <= values.size(); ++i) {
    while (!open.empty() && (i == values.size() || values[open.back()] > values[i])) {
      runs[open.back()].last = i - 1;
      open.pop_back();
    }
    if (i == values.size()) break;
    const bool equal = !open.empty() && values[open.back()] == values[i];
    runs[i].first = equal ? runs[open.back()].first : (open.empty() ? 0 : open.back() + 1);
    open.push_back(i);
  }
  return runs;
}

void find_spans(const SimulatedRide& simulated, const ForceLimitCurves& envelope, int car, ForceAxis axis,
                std::vector<Overload>& out) {
  const std::vector<float> values = pressed(simulated, car, axis, envelope.cutoff);
  if (values.size() < 2) return;
  const EnvelopeCurve& curve = envelope.curves[static_cast<std::size_t>(axis)];
  const std::vector<LongestRun> runs = runs_at_least(values);
  struct Over {
    double excess = 0, allowed = 0;
  };
  std::vector<Over> over(values.size());
  std::vector<int> edges(values.size() + 1, 0);
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double seconds = static_cast<double>(runs[i].last - runs[i].first) / kForceRate;
    if (seconds < envelope.shortest) continue;
    const double allowed = limit(curve, seconds);
    if (!(values[i] > allowed)) continue;
    over[i] = {values[i] - allowed, allowed};
    ++edges[runs[i].first], --edges[runs[i].last + 1];
  }
  const auto distance = [&](std::size_t entry) { return simulated.distance(simulated.sample_of(entry), car); };
  int depth = 0;
  std::size_t begin = 0;
  for (std::size_t i = 0; i <= values.size(); ++i) {
    const int before = depth;
    depth += i < values.size() ? edges[i] : -depth;
    if (before == 0 && depth > 0) begin = i;
    if (!(before > 0 && depth == 0)) continue;
    const std::span<const Over> run(&over[begin], i - begin);
    const auto worst = begin + static_cast<std::size_t>(std::ranges::max_element(run, {}, &Over::excess) - run.begin());
    out.push_back({car, axis, static_cast<double>(begin) / kForceRate, static_cast<double>(i - 1) / kForceRate,
                   distance(begin), distance(i - 1), values[worst], over[worst].allowed,
                   static_cast<double>(worst) / kForceRate});
  }
}

// Returns low-passed felt g of a car that passes tight bends: what happens between two entries counts when it happens,
// at kFiner times their rate. An entry shows the peak next to it, if there is one.
std::vector<float> low_passed_finely(const SimulatedRide& simulated, int car, float FeltAcceleration::*axis,
                                     double cutoff, std::span<const float> entries) {
  constexpr std::size_t kFiner = 8;
  constexpr double kRate = kFiner * kForceRate;
  const std::size_t last = kFiner * (entries.size() - 1);
  std::vector<float> fine(last + 1, 0.0f);
  const auto add = [&](double place, double value) {  // at an entry
    const double at = std::clamp(place * kFiner, 0.0, static_cast<double>(last));
    const std::size_t i = std::min(static_cast<std::size_t>(at), last - 1);
    const double share = at - static_cast<double>(i);
    fine[i] += static_cast<float>((1 - share) * value), fine[i + 1] += static_cast<float>(share * value);
  };
  std::vector<bool> whole(entries.size(), false);  // the passage has all of what happens before the entry
  for (const JointPassage& passage : simulated.passages)
    if (passage.car == car)
      add(passage.time * kForceRate, kRate * (double{passage.impulse.*axis} + double{passage.missed.*axis}));
  for (const BendPassage& bend : simulated.bends) {
    if (bend.peak.car != car) continue;
    whole[bend.peak.entry] = true;
    // A mass at its centre, or one at either end where it changes sign.
    const double before = bend.for_before.*axis, after = bend.for_entry.*axis,
                 end = static_cast<double>(bend.peak.entry);
    if (before * after > 0) {
      add(end - before / (before + after), kRate * (before + after));
    } else {
      add(end - 1, kRate * before), add(end, kRate * after);
    }
  }
  for (std::size_t k = 1; k < entries.size(); ++k)
    for (std::size_t j = 0; j <= kFiner && !whole[k]; ++j)
      fine[kFiner * (k - 1) + j] +=
          (j % kFiner == 0 ? 0.5f : 1.0f) * std::lerp(entries[k - 1], entries[k], static_cast<float>(j) / kFiner);
  fine.front() = entries.front();  // the filter starts with it
  fine.back() += 0.5f * entries.back();
  low_pass(fine, kRate, cutoff);
  std::vector<float> values(entries.size());
  for (std::size_t k = 0; k < values.size(); ++k) {
    const std::size_t at = k * kFiner, from = std::max(at, kFiner / 2) - kFiner / 2 + 1,
                      to = std::min(at + kFiner / 2, last - 1);
    values[k] = fine[at];
    for (std::size_t i = from; i <= to; ++i)
      if ((fine[i] - fine[i - 1]) * (fine[i + 1] - fine[i]) < 0) values[k] = fine[i];
  }
  return values;
}

// --- Advice on overloads

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

const ForceLimitCurves& default_envelope(world::CoasterKind kind) {
  static const ForceLimitCurves kDefault{
      {EnvelopeCurve{{0.2, 6}, {1, 6}, {2, 4}, {4, 4}, {5, 3}, {11.8, 3}, {12, 2}},
       EnvelopeCurve{{0.2, 2}, {0.5, 1.5}, {4, 1.5}, {7, 1.1}}, EnvelopeCurve{{0.2, 3}, {1, 3}, {2, 2}},
       EnvelopeCurve{{0.2, 6}, {1, 6}, {2, 4}, {4, 4}, {5, 3}, {11.8, 3}, {12, 2.5}},
       EnvelopeCurve{{0.2, 3.5}, {2, 3.5}, {3, 2.5}, {4, 2.5}, {5, 2}}},
      0.2,
      5.0};
  static const std::vector<ForceLimitCurves> kOfKinds = [] {
    std::vector<ForceLimitCurves> all;
    for (const world::CoasterKindRow& row : rows_of(world::CoasterKind{})) {
      all.push_back(kDefault);
      for (EnvelopeCurve& curve : all.back().curves)
        for (ForceLimitPoint& point : curve) point.g *= row.limits;
    }
    return all;
  }();
  return kOfKinds[static_cast<std::size_t>(kind)];
}

double limit(const EnvelopeCurve& curve, double seconds) {
  if (curve.empty()) return 1e9;
  if (seconds <= curve.front().seconds) return curve.front().g;
  for (std::size_t i = 1; i < curve.size(); ++i) {
    if (seconds > curve[i].seconds) continue;
    const double part = (seconds - curve[i - 1].seconds) / (curve[i].seconds - curve[i - 1].seconds);
    return curve[i - 1].g + part * (curve[i].g - curve[i - 1].g);
  }
  return curve.back().g;
}

void low_pass(std::span<float> values, double rate, double cutoff) {
  if (values.empty()) return;
  // The two pole pairs of a fourth-order Butterworth filter.
  FilterSection(rate, cutoff, 0.54119610014619698).run(values);
  FilterSection(rate, cutoff, 1.30656296487637652).run(values);
}

std::vector<float> low_passed_g(const SimulatedRide& simulated, int car, float FeltAcceleration::*axis, double cutoff) {
  std::vector<float> values(simulated.entries());
  for (std::size_t k = 0; k < values.size(); ++k) values[k] = simulated.felt(k, car).*axis;
  if (values.size() > 1 &&
      std::ranges::any_of(simulated.bends, [&](const BendPassage& bend) { return bend.peak.car == car; }))
    return low_passed_finely(simulated, car, axis, cutoff, values);
  for (const JointPassage& passage : simulated.passages) {
    if (passage.car != car) continue;
    values[passage.entry] += passage.impulse.*axis * static_cast<float>(kForceRate);
    // The nearer of two entries takes more of what both missed. The first stays: the filter starts with it.
    const double place = passage.time * kForceRate - static_cast<double>(passage.entry - 1);
    const float share = passage.entry > 1 ? static_cast<float>(std::clamp(place, 0.0, 1.0)) : 1.0f,
                missed = passage.missed.*axis * static_cast<float>(kForceRate);
    values[passage.entry] += share * missed;
    if (passage.entry > 1) values[passage.entry - 1] += (1 - share) * missed;
  }
  low_pass(values, kForceRate, cutoff);
  return values;
}

std::vector<float> pressed(const SimulatedRide& simulated, int car, ForceAxis axis, double cutoff) {
  std::vector<float> values = low_passed_g(simulated, car, seat_axis(axis), cutoff);
  // Lateral g is low-passed with its sign: a force that changes sides quickly does not last.
  for (float& value : values)
    if (axis == ForceAxis::side) value = std::abs(value);
    else if (axis == ForceAxis::lift || axis == ForceAxis::back) value = -value;
  return values;
}

std::vector<Overload> red_spans(const SimulatedRide& simulated, const ForceLimitCurves& envelope) {
  std::vector<Overload> spans;
  for (int car = 0; car < simulated.start.cars; ++car)
    for (std::size_t axis = 0; axis < kForceAxes; ++axis)
      find_spans(simulated, envelope, car, static_cast<ForceAxis>(axis), spans);
  return spans;
}

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
