#include "sim/plan/force_quantity.h"

#include <algorithm>
#include <cmath>

#include "base/portable_math.h"
#include "curve/continuity.h"

namespace coaster::sim {
namespace {

using world::ForceKey, world::ForceOf, world::ForceOver, world::ForceProgram;

double speed_at(const ForcePoint& point) {
  return std::sqrt(std::max(point.square, world::kSlowestForce * world::kSlowestForce));
}
bool is_rate(const ForceProgram& program, std::size_t channel) {
  return program.of == ForceOf::forces && static_cast<world::ForceChannel>(channel) == world::ForceChannel::roll;
}

// Values at the plan's points.
struct Samples {
  std::vector<double> at, values, slopes;
  // Returns the key of the curve there.
  ForceKey key(const ForcePlan& plan, double place) const {
    const auto of = [&](const std::vector<double>& list) {
      return between_points(plan, place, [&](std::size_t i) { return list[i]; });
    };
    return {place, of(values), of(slopes)};
  }
};

Samples samples_of(const ForcePlan& plan, ForceOf of, std::size_t channel) {
  Samples samples;
  double angle = 0;
  for (std::size_t i = 0; i < plan.path.points.size(); ++i) {
    const ForcePoint& point = plan.path.points[i];
    const ElementPoint& on = plan.path.curve.points[i];
    if (i > 0) {
      const ElementPoint& before = plan.path.curve.points[i - 1];
      angle += base::degrees((before.spin + on.spin) / 2 * (on.s - before.s));
    }
    const double rate = base::degrees(on.spin) * (plan.task.program.over == ForceOver::time ? speed_at(point) : 1.0);
    const std::array<double, 3> forces{point.up, point.side, rate},
        bends{glm::dot(on.curvature, on.up), glm::dot(on.curvature, glm::cross(on.up, on.tangent)), angle};
    samples.at.push_back(point.at), samples.values.push_back((of == ForceOf::forces ? forces : bends)[channel]);
  }
  for (std::size_t i = 0; i < samples.at.size(); ++i) {
    const std::size_t low = i == 0 ? 0 : i - 1, high = std::min(i + 1, samples.at.size() - 1);
    const double gap = samples.at[high] - samples.at[low];
    samples.slopes.push_back(gap > 0 ? (samples.values[high] - samples.values[low]) / gap : 0.0);
  }
  return samples;
}

ForceKey limited(const ForceProgram& program, world::ForceChannel channel, ForceKey key) {
  const double limit = world::channel_of(program.of, channel).limit;
  key.value = std::clamp(key.value, -limit, limit);
  key.slope = std::clamp(key.slope, -world::kMostForceSlope, world::kMostForceSlope);
  return key;
}

// Puts keys of the samples at the places, and more where the curve between them is off by more than `unit`.
void put_keys(const ForcePlan& plan, const Samples& samples, world::ForceChannel channel, double unit,
              ForceProgram& program) {
  std::vector<ForceKey>& keys = program.keys(channel);
  const double gap = world::key_gap_of(program.over);
  for (ForceKey& key : keys) key = limited(program, channel, samples.key(plan, key.at));
  const auto put = [&](double at) {
    const auto next = std::find_if(keys.begin(), keys.end(), [&](const ForceKey& key) { return key.at > at - gap; });
    if (next != keys.end() && next->at < at + gap) return false;
    keys.insert(next, limited(program, channel, samples.key(plan, at)));
    return true;
  };
  put(0), put(samples.at.back());
  std::vector<double> tried;
  while (keys.size() < world::kMostForceKeys) {
    const ForceCurve curve(program, channel);
    double most = unit;
    std::size_t worst = 0;
    for (std::size_t i = 1; i + 1 < samples.at.size(); ++i) {
      const double off = std::abs(curve.at(samples.at[i]).value - samples.values[i]);
      if (off <= most || std::find(tried.begin(), tried.end(), samples.at[i]) != tried.end()) continue;
      most = off, worst = i;
    }
    if (worst == 0) break;
    if (!put(samples.at[worst])) tried.push_back(samples.at[worst]);
  }
}

}  // namespace

world::ForceProgram over_other_axis(const ForcePlan& plan) {
  const world::ForceProgram& from = plan.task.program;
  world::ForceProgram to = from;
  const bool by_time = from.over == ForceOver::distance;
  to.over = by_time ? ForceOver::time : ForceOver::distance;
  const ForcePoint& last = plan.path.points.back();
  const auto speed = [&](double at) {
    return between_points(plan, at, [&](std::size_t i) { return speed_at(plan.path.points[i]); });
  };
  const auto place = [&](double at) {
    const double here = between_points(
        plan, at, [&](std::size_t i) { return by_time ? plan.path.points[i].time : plan.path.curve.points[i].s; });
    const double beyond = std::max(at - last.at, 0.0);  // at the last speed
    return here + (by_time ? beyond / speed(at) : beyond * speed(at));
  };
  const double longest = world::longest_of(to.over);
  to.length = std::clamp(place(from.length), world::shortest_of(to.over), longest);
  for (std::size_t c = 0; c < to.channels.size(); ++c)
    for (world::ForceKey& key : to.channels[c]) {
      const double v = speed(key.at), unit = by_time ? 1 / v : v;  // of the new axis per unit of the old one
      if (is_rate(from, c)) key.value /= unit, key.slope /= unit;
      key.at = std::min(place(key.at), longest);
      key.slope = std::clamp(key.slope / unit, -world::kMostForceSlope, world::kMostForceSlope);
      key.before = std::min(key.before * unit, longest), key.after = std::min(key.after * unit, longest);
    }
  return to;
}

ForceProgram of_other_quantity(const ForcePlan& plan) {
  constexpr double kUnits[] = {0.005, 0.005, 0.01};  // g, g, degrees per metre
  constexpr double kAngle = 0.1;                     // degrees
  ForceProgram to = plan.task.program;
  const bool bends = to.of == ForceOf::forces;
  to.of = bends ? ForceOf::curvature : ForceOf::forces;
  to.length = plan.task.length();
  for (std::size_t c = 0; c < to.channels.size(); ++c) {
    const bool roll = c == 2;
    double unit = kUnits[c];
    if (bends) unit = roll ? kAngle : unit * kCurvaturePerG;
    else if (roll && to.over == ForceOver::time) unit *= plan.task.program.speed;
    std::erase_if(to.channels[c], [&](const ForceKey& key) { return key.at > plan.path.points.back().at; });
    put_keys(plan, samples_of(plan, to.of, c), static_cast<world::ForceChannel>(c), unit, to);
  }
  return to;
}

std::array<double, 3> curvature_at(const Derived& derived, std::size_t first, double distance) {
  const TrackPlace place = place_at(derived, std::min(distance, std::nextafter(derived.length, 0.0)));
  const SegmentShape& shape = derived.shape_at(place.index);
  const double t = shape.arc.parameter(place.s);
  const curve::Frame frame = frame_at(shape, place.s, t);
  const glm::dvec3 bend = curve::curvature_vector(shape.key.cubic, t);
  double angle = shape.roll.angle(place.s);
  for (std::size_t i = first; i < place.index; ++i) angle += derived.shape_at(i).roll.twist;
  return {glm::dot(bend, frame.up), glm::dot(bend, frame.left()), base::degrees(angle)};
}

}  // namespace coaster::sim
