// Where carts are in space, how they are turned, and what their riders feel.
#include <cmath>

#include "sim/ride.h"

namespace coaster::sim {
namespace {

using glm::dvec3;

// A point of the heartline at `offset` metres of rail from a place; straight on beyond the ends of an open track.
dvec3 heartline_point(const Derived& derived, double distance, double heartline) {
  const double clamped = derived.closed ? distance : std::fmin(std::fmax(distance, 0.0), derived.length);
  const TrackPlace place = place_at(derived, clamped);
  const SegmentShape& shape = derived.shape(derived.order[place.index]);
  const curve::Frame frame = frame_at(shape, place.s);
  const dvec3 rail = curve::point(shape.key.cubic, shape.arc.parameter(place.s));
  return rail + heartline * frame.up + (distance - clamped) * (derived.closed ? dvec3(0) : frame.forward);
}

}  // namespace

Pose pose(const Derived& derived, const world::CartMotion& cart, world::FrameMethod method) {
  const SegmentShape& shape = derived.shape(cart.segment);
  const double t = shape.arc.parameter(cart.s);
  Pose out;
  out.position = curve::point(shape.key.cubic, t);
  out.frame = frame_at(shape, cart.s);
  if (method == world::FrameMethod::frenet) {
    const auto frenet = curve::frenet(shape.key.cubic, t);
    out.frenet_defined = frenet.has_value();
    if (frenet) out.frame = {frenet->tangent, frenet->normal};
  }
  return out;
}

Felt felt(const Derived& derived, const world::CartMotion& cart, double heartline) {
  // a = s'' h'(s) + s'^2 h''(s) along the heartline h, by central differences over +-kStep of rail.
  constexpr double kStep = 0.02;
  const SegmentShape& shape = derived.shape(cart.segment);
  const curve::Frame frame = frame_at(shape, cart.s);
  const double distance = cart.track_distance;
  const dvec3 before = heartline_point(derived, distance - kStep, heartline), here = heartline_point(derived, distance, heartline),
              after = heartline_point(derived, distance + kStep, heartline);
  const dvec3 first = (after - before) / (2.0 * kStep), second = (after - 2.0 * here + before) / (kStep * kStep);
  const double acceleration = -world::kGravity * frame.forward.y;
  const dvec3 a = acceleration * first + cart.speed * cart.speed * second + dvec3(0, world::kGravity, 0);
  return {glm::dot(a, frame.up) / world::kGravity, glm::dot(a, frame.left()) / world::kGravity,
          glm::dot(a, frame.forward) / world::kGravity};
}

}  // namespace coaster::sim
