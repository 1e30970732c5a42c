// Positions and frames along the derived track.
#include <algorithm>
#include <array>

#include "base/check.h"
#include "base/portable_math.h"
#include "curve/carried_frame.h"
#include "sim/shape/derived.h"

namespace coaster::sim {
namespace {

using glm::dvec3;

using Frames = std::array<curve::Frame, kFrameIntervals + 1>;

double at_uniform(int i) { return static_cast<double>(i) / kFrameIntervals; }

// Finds the intervals that need several steps. Replaces the frames unless those of single steps are within the bound.
void refine(const curve::Cubic& cubic, Frames& frames, std::uint32_t& tight) {
  constexpr double kSpare = 0.25 * curve::kFrameBound;  // for the step from a stored frame to a place in its interval
  const curve::CoefficientsD c = curve::coefficients_d(cubic);
  double off = 0;
  for (int i = 0; i < kFrameIntervals; ++i) {
    const double error = curve::step_error(c, at_uniform(i), 1.0 / kFrameIntervals);
    off += error;
    if (!(error <= kSpare)) tight |= 1u << i;
  }
  if (curve::cusps(cubic).count > 0) tight = ~0u;
  if (tight == 0 && off <= 0.5 * curve::kFrameBound) return;
  off = 0;
  Frames fine = frames;
  for (int i = 0; i < kFrameIntervals; ++i) {
    fine[i + 1] = curve::carried(cubic, fine[i], at_uniform(i), at_uniform(i + 1));
    off = std::max(off, glm::length(fine[i + 1].up - frames[i + 1].up));
  }
  if (off > curve::kFrameBound - kSpare) frames = fine;
}

}  // namespace

void build_frames(SegmentShape& shape) {
  const ShapeKey& key = shape.key;
  const curve::Cubic& c = key.cubic;
  Frames frames;
  dvec3 last = curve::point(c, 0.0);
  const dvec3 start = curve::unit_tangent(c, 0.0);
  frames[0] = {start, curve::perpendicular(start, dvec3(key.up_from))};
  for (int i = 1; i <= kFrameIntervals; ++i) {
    const double t = at_uniform(i);
    const dvec3 here = curve::point(c, t);
    frames[i] = curve::transport(frames[i - 1], last, here, curve::unit_tangent(c, t));
    last = here;
  }
  shape.tight = 0;
  if (!(curve::steps_error(c, kFrameIntervals) <= 0.5 * curve::kFrameBound)) refine(c, frames, shape.tight);
  const curve::Frame& end = frames.back();
  const dvec3 wanted = curve::perpendicular(end.forward, dvec3(key.up_to));
  const double twist = curve::signed_angle(end.up, wanted, end.forward) + key.turns * 2.0 * base::kPi;
  shape.roll = {shape.arc.length(), twist, key.spin_from, key.spin_to};
  for (int i = 0; i <= kFrameIntervals; ++i) {
    dvec3& up = shape.ups[i];
    up = frames[i].up;
    if (i == 0 || !(shape.roll.length > 0)) continue;
    const double angle = i == kFrameIntervals ? twist : shape.roll.angle(shape.arc.distance(at_uniform(i)));
    up = curve::rotate(up, frames[i].forward, angle);
  }
}

TrackPlace place_at(const Derived& derived, double distance) {
  COASTER_CHECK(!derived.order.empty(), "a place needs a segment");
  distance = within_lap(distance, derived.length, derived.closed);
  if (derived.closed && distance >= derived.length) distance = 0;
  distance = std::clamp(distance, 0.0, derived.length);
  const auto above = std::upper_bound(derived.starts.begin(), derived.starts.end(), distance);
  std::size_t index = static_cast<std::size_t>(above - derived.starts.begin());
  index = std::min(index == 0 ? 0 : index - 1, derived.order.size() - 1);
  return {index, distance - derived.starts[index]};
}

bool has_cusp(const SegmentShape& shape) { return shape.tight != 0 && curve::cusps(shape.key.cubic).count > 0; }

bool has_cusp(const Derived& derived) {
  return std::ranges::any_of(derived.order, [&](world::Entity e) { return has_cusp(derived.shape(e)); });
}

curve::Frame frame_at(const SegmentShape& shape, double s) { return frame_at(shape, s, shape.arc.parameter(s)); }

curve::Frame frame_at(const SegmentShape& shape, double s, double t) {
  const curve::Cubic& c = shape.key.cubic;
  const double length = shape.arc.length();
  if (!(s > 0)) return shape.frame(0);
  if (s >= length) return shape.frame(kFrameIntervals);
  const int below = std::min(static_cast<int>(t * kFrameIntervals), kFrameIntervals - 1);
  const double t0 = at_uniform(below);
  const double rolled = shape.roll.angle(shape.arc.distance(t0));
  curve::Frame frame = shape.frame(below);
  if ((shape.tight >> below & 1u) != 0) {
    // Without the roll, whose sense a cusp reverses with the direction of travel.
    frame.up = curve::rotate(frame.up, frame.forward, -rolled);
    frame = curve::carried(c, frame, t0, t);
    frame.up = curve::rotate(frame.up, frame.forward, shape.roll.angle(s));
    return frame;
  }
  frame = curve::transport(frame, curve::point(c, t0), curve::point(c, t), curve::unit_tangent(c, t));
  frame.up = curve::rotate(frame.up, frame.forward, shape.roll.angle(s) - rolled);
  return frame;
}

}  // namespace coaster::sim
