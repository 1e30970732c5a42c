// The rows of the table of frame methods. frenet_breaks.cpp finds where Frenet-Serret fails.
#include "sim/shape/frame_methods.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "base/check.h"
#include "base/portable_math.h"

namespace coaster::sim {
namespace {

using glm::dvec3;

// Returns the rotation of the knots' frames since the track's start, relative to rotation-minimising frames.
double turned(const Derived& derived, std::size_t index, double s) {
  const SegmentShape& shape = derived.shape_at(index);
  return derived.twists[index] + shape.roll.angle(std::clamp(s, 0.0, shape.roll.length));
}

curve::Frame rolled(curve::Frame frame, double radians) {
  frame.up = curve::rotate(frame.up, frame.forward, radians);
  return frame;
}

TrackFrame by_knots(const Derived& derived, std::size_t index, double s) {
  return {frame_at(derived.shape_at(index), s)};
}

TrackFrame minimising(const Derived& derived, std::size_t index, double s) {
  // Double reflection turns a vector rigidly with the frame, so the knots' frame gives all carried frames.
  const double spread = derived.length > 0 ? loop_twist(derived) * (derived.starts[index] + s) / derived.length : 0.0;
  return {rolled(frame_at(derived.shape_at(index), s), spread - turned(derived, index, s))};
}

// The last Frenet normal before a position without one: its angle to the knots' frame there, and that frame's rotation.
struct LastNormal {
  double angle, turned;
};
std::optional<LastNormal> last_normal(const Derived& derived, std::size_t index, double before) {
  const std::size_t count = derived.order.size();
  double whole_laps = 0;
  for (std::size_t back = 0; back <= std::min<std::size_t>(kFrenetReach, count); ++back) {
    const SegmentShape& shape = derived.shape_at(index);
    // The current segment is searched finely, those before it coarsely: most are straight from end to end or nowhere.
    const int intervals = back == 0 ? kFrameIntervals : 8;
    for (int i = intervals; i >= 0; --i) {
      const double t = static_cast<double>(i) / intervals;
      if (back == 0 && t >= before) continue;
      const auto found = curve::frenet(shape.key.cubic, t);
      if (!found) continue;
      const double s = shape.arc.distance(t);
      const curve::Frame frame = frame_at(shape, s);
      return LastNormal{curve::signed_angle(frame.up, found->normal, frame.forward),
                        turned(derived, index, s) + whole_laps};
    }
    if (index == 0 && !derived.closed) return std::nullopt;
    if (index == 0) whole_laps -= derived.twists.back();
    index = index == 0 ? count - 1 : index - 1;
  }
  return std::nullopt;
}

TrackFrame frenet_serret(const Derived& derived, std::size_t index, double s) {
  const SegmentShape& shape = derived.shape_at(index);
  const double t = shape.arc.parameter(s);
  if (const auto found = curve::frenet(shape.key.cubic, t)) return {{found->tangent, found->normal}};
  const curve::Frame frame = frame_at(shape, s);
  const auto last = last_normal(derived, index, t);
  if (!last) return {frame, false};
  return {rolled(frame, last->angle + last->turned - turned(derived, index, s)), false};
}

TrackFrame world_up(const Derived& derived, std::size_t index, double s) {
  const SegmentShape& shape = derived.shape_at(index);
  const dvec3 forward = curve::unit_tangent(shape.key.cubic, shape.arc.parameter(s));
  const bool vertical = forward.x * forward.x + forward.z * forward.z < 1e-12;
  return {{forward, curve::perpendicular(forward, vertical ? dvec3(1, 0, 0) : dvec3(0, 1, 0))}, !vertical};
}

constexpr std::array<FrameMethodRow, 4> kFrameMethods{{
    {"knots", "Banked by the knots",
     "The knots' up carried by double reflection, and turned to the next knot's up by the spins of both knots.",
     by_knots},
    {"rmf", "Rotation-minimising",
     "The first knot's up carried along the whole track by double reflection (Wang et al. 2008); a loop's remaining "
     "twist is spread.",
     minimising},
    {"frenet", "Frenet-Serret",
     "T, N = T'/|T'|, B = T \u00D7 N. Undefined on straights, and flips across an inflection.", frenet_serret},
    {"world_up", "World up", "As upright as possible: left is level. Undefined on a vertical, and unstable near one.",
     world_up},
}};
static_assert(static_cast<std::size_t>(world::FrameMethod::world_up) + 1 == kFrameMethods.size(),
              "one row for each enumerator");

}  // namespace

std::span<const FrameMethodRow> frame_methods() { return kFrameMethods; }

TrackFrame track_frame(const Derived& derived, world::FrameMethod method, std::size_t index, double s) {
  COASTER_CHECK(index < derived.order.size(), "frames exist only on segments of the track");
  return base::row_of(method).frame(derived, index, s);
}

std::size_t index_of_segment(const Derived& derived, world::Entity segment, double near) {
  if (!derived.order.empty()) {
    const std::size_t guess = place_at(derived, near).index;
    if (derived.order[guess] == segment) return guess;
  }
  return static_cast<std::size_t>(std::find(derived.order.begin(), derived.order.end(), segment) -
                                  derived.order.begin());
}

double loop_twist(const Derived& derived) {
  if (!derived.closed || derived.twists.empty()) return 0.0;
  const double twist = std::remainder(derived.twists.back(), 2.0 * base::kPi);
  return twist <= -base::kPi ? base::kPi : twist;
}

}  // namespace coaster::sim
