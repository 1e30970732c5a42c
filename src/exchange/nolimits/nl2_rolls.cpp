// Chooses the rolls that a file needs.
#include "exchange/nolimits/nl2_rolls.h"

#include <algorithm>
#include <cmath>

#include "base/portable_math.h"

namespace coaster::exchange {
namespace {

using glm::dvec3;

struct Sample {
  double s = 0, angle = 0;  // m; rad against the rotation-minimising frame
  curve::Frame frame;
  bool chosen = false;
};

// Returns the track's frames at most kRollStep apart; those at the knots are chosen.
std::vector<Sample> samples_of(const sim::Derived& derived) {
  std::vector<Sample> samples;
  curve::Frame carried;
  dvec3 last(0);
  const auto add = [&](const sim::SegmentShape& shape, double start, double within, bool chosen) {
    const curve::Frame frame = sim::frame_at(shape, within);
    const dvec3 here = curve::point(shape.key.cubic, shape.arc.parameter(within));
    carried = samples.empty() ? frame : curve::transport(carried, last, here, frame.forward);
    last = here;
    double angle = curve::signed_angle(carried.up, frame.up, frame.forward);
    if (!samples.empty()) angle += 2 * base::kPi * std::round((samples.back().angle - angle) / (2 * base::kPi));
    samples.push_back({start + within, angle, frame, chosen});
  };
  for (std::size_t i = 0; i < derived.order.size(); ++i) {
    const sim::SegmentShape& shape = derived.shape(derived.order[i]);
    const double length = shape.arc.length();
    const int steps = std::max(1, static_cast<int>(std::floor(length / kRollStep)));
    for (int k = 0; k < steps; ++k) add(shape, derived.starts[i], length * k / steps, k == 0);
    if (i + 1 == derived.order.size()) add(shape, derived.starts[i], length, true);
  }
  return samples;
}

// Returns true if every interpretation of the rolls between two samples matches the samples between them.
bool reads_well(const std::vector<Sample>& samples, std::size_t from, std::size_t to, const RollSpline& spline) {
  const double bound = base::radians(kRollError);
  const Sample &a = samples[from], &b = samples[to];
  const double length = b.s - a.s, turn = b.angle - a.angle;
  if (std::abs(turn) > base::kPi / 2) return false;
  for (std::size_t i = from + 1; i < to; ++i) {
    const Sample& here = samples[i];
    const double u = (here.s - a.s) / length, v = 1 - u, wanted = here.angle - a.angle;
    const dvec3 mixed = curve::perpendicular(here.frame.forward, v * a.frame.up + u * b.frame.up);
    if (std::abs(u * turn - wanted) > bound ||
        std::abs(spline.at(here.s).angle - here.angle) > base::radians(kSplineError) ||
        curve::angle_between(mixed, here.frame.up) > bound)
      return false;
  }
  return true;
}

}  // namespace

std::vector<double> roll_places(const sim::Derived& derived) {
  std::vector<Sample> samples = samples_of(derived);
  std::vector<std::size_t> points;
  for (std::size_t added = 1; added > 0;) {
    points.clear();
    std::vector<RollPoint> rolls;
    for (std::size_t i = 0; i < samples.size(); ++i)
      if (samples[i].chosen) points.push_back(i), rolls.push_back({samples[i].s, samples[i].angle});
    const RollSpline spline(std::move(rolls));
    added = 0;
    for (std::size_t i = 0; i + 1 < points.size(); ++i)
      if (points[i + 1] - points[i] > 1 && !reads_well(samples, points[i], points[i + 1], spline)) {
        samples[(points[i] + points[i + 1]) / 2].chosen = true;
        ++added;
      }
  }
  std::vector<double> places;
  for (const std::size_t i : points) places.push_back(samples[i].s);
  return places;
}

}  // namespace coaster::exchange
