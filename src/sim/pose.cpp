// Where carts are in space, how they are turned, and what their riders feel.
#include <cmath>

#include "base/check.h"
#include "sim/frame_methods.h"
#include "sim/ride.h"

namespace coaster::sim {
namespace {

using glm::dvec3;

// The point of the heartline over arc length s of a segment.
dvec3 heartline_point(const SegmentShape& shape, double s, double heartline) {
  return curve::point(shape.key.cubic, shape.arc.parameter(s)) + heartline * frame_at(shape, s).up;
}

}  // namespace

Pose pose(const Derived& derived, const world::CartMotion& cart, world::FrameMethod method) {
  const SegmentShape& shape = derived.shape(cart.segment);
  const double t = shape.arc.parameter(cart.s);
  const std::size_t index = index_of_segment(derived, cart.segment, cart.track_distance);
  COASTER_CHECK(index < derived.order.size(), "a cart is on a segment of the track");
  const TrackFrame at = track_frame(derived, method, index, cart.s);
  return {curve::point(shape.key.cubic, t), at.frame, at.defined};
}

Felt felt(const Derived& derived, const world::CartMotion& cart, double heartline) {
  // a = s'' h'(s) + s'^2 h''(s) along the heartline h, by central differences over +-step of rail. The stencil stays within the
  // segment: the roll rate may jump at a joint, which the heartline answers with a corner, and a difference over it with noise.
  const SegmentShape& shape = derived.shape(cart.segment);
  const double length = shape.arc.length(), step = std::fmin(0.02, 0.25 * length);
  const double s = std::fmin(std::fmax(cart.s, step), length - step);
  const curve::Frame frame = frame_at(shape, s);
  if (!(step > 0)) return {frame.up.y, frame.left().y, frame.forward.y};  // no length: at rest, whatever the speed
  const dvec3 before = heartline_point(shape, s - step, heartline), here = heartline_point(shape, s, heartline),
              after = heartline_point(shape, s + step, heartline);
  const dvec3 first = (after - before) / (2.0 * step), second = (after - 2.0 * here + before) / (step * step);
  const double acceleration = -world::kGravity * frame.forward.y;
  const dvec3 a = acceleration * first + cart.speed * cart.speed * second + dvec3(0, world::kGravity, 0);
  return {glm::dot(a, frame.up) / world::kGravity, glm::dot(a, frame.left()) / world::kGravity,
          glm::dot(a, frame.forward) / world::kGravity};
}

}  // namespace coaster::sim
