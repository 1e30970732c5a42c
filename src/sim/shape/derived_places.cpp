// Positions and frames along the derived track.
#include <algorithm>

#include "base/check.h"
#include "sim/shape/derived.h"

namespace coaster::sim {

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

curve::Frame frame_at(const SegmentShape& shape, double s) { return frame_at(shape, s, shape.arc.parameter(s)); }

curve::Frame frame_at(const SegmentShape& shape, double s, double t) {
  const curve::Cubic& c = shape.key.cubic;
  const double length = shape.arc.length();
  if (!(s > 0)) return shape.frame(0);
  if (s >= length) return shape.frame(kFrameIntervals);
  const int below = std::min(static_cast<int>(t * kFrameIntervals), kFrameIntervals - 1);
  const double t0 = static_cast<double>(below) / kFrameIntervals;
  curve::Frame frame =
      curve::transport(shape.frame(below), curve::point(c, t0), curve::point(c, t), curve::unit_tangent(c, t));
  frame.up = curve::rotate(frame.up, frame.forward, shape.roll.angle(s) - shape.roll.angle(shape.arc.distance(t0)));
  return frame;
}

}  // namespace coaster::sim
