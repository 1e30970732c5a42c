// Position and orientation of cars, and the forces on their riders.
#include <cmath>

#include "base/check.h"
#include "sim/ride/ride_parts.h"
#include "sim/shape/frame_methods.h"

namespace coaster::sim {
namespace {

using glm::dvec3;

// Returns the heartline's point at arc length s of a segment.
dvec3 heartline_point(const SegmentShape& shape, double s, double heartline) {
  return curve::point(shape.key.cubic, shape.arc.parameter(s)) + heartline * frame_at(shape, s).up;
}

}  // namespace

std::vector<TrackPlace> places_of(const world::Document& document, const Derived& derived, world::Entity entity,
                                  const world::CartMotion& motion) {
  const world::Cart* const design = document.entities.find<world::Cart>(entity);
  std::vector<TrackPlace> places;
  place_cars(derived, front_place(derived, motion), design ? cars_on(derived, *design) : 1,
             design ? design->spacing : 1.0, places);
  return places;
}

double acceleration_of(TrainContext context, double speed) {
  context.direction = speed > 0 ? 1.0 : speed < 0 ? -1.0 : 0.0;
  return context.gravity(0.0) + context.others(speed);
}

Pose pose(const Derived& derived, TrackPlace place, world::FrameMethod method) {
  const SegmentShape& shape = derived.shape_at(place.index);
  const double length = shape.arc.length(), s = std::fmin(std::fmax(place.s, 0.0), length);
  const TrackFrame at = track_frame(derived, method, place.index, s);
  // A car beyond an open end is on the straight continuation.
  return {curve::point(shape.key.cubic, shape.arc.parameter(s)) + (place.s - s) * at.frame.forward, at.frame,
          at.defined};
}

Pose pose(const Derived& derived, const world::CartMotion& cart, world::FrameMethod method) {
  return pose(derived, front_place(derived, cart), method);
}

std::vector<Pose> car_poses(const world::Document& document, const Derived& derived, world::Entity entity,
                            const world::CartMotion& motion, world::FrameMethod method) {
  std::vector<Pose> poses;
  const world::Cart* const design = document.entities.find<world::Cart>(entity);
  for (const TrackPlace& place : places_of(document, derived, entity, motion)) {
    poses.push_back(pose(derived, place, method));
    poses.back().leads = poses.size() == 1;
    if (design) poses.back().length = design->body();
  }
  return poses;
}

Felt felt(const world::Document& document, const Derived& derived, world::Entity entity, const world::CartMotion& cart,
          int car) {
  const std::vector<TrackPlace> places = places_of(document, derived, entity, cart);
  COASTER_CHECK(car >= 0 && static_cast<std::size_t>(car) < places.size(), "the train has this car");
  const TrackPlace place = places[static_cast<std::size_t>(car)];
  // a = s'' h'(s) + s'^2 h''(s) along the heartline h, by central differences over +-step of rail. The stencil stays
  // within the segment: the roll rate may jump at a joint, where the heartline then has a corner and a difference
  // across it gives noise.
  const SegmentShape& shape = derived.shape_at(place.index);
  const double length = shape.arc.length(), step = std::fmin(0.02, 0.25 * length);
  const double s = std::fmin(std::fmax(place.s, step), length - step);
  const curve::Frame frame = frame_at(shape, s);
  if (!(step > 0)) return {frame.up.y, frame.left().y, frame.forward.y};  // a segment of zero length: as at rest
  const double d = document.heartline;
  const dvec3 before = heartline_point(shape, s - step, d), here = heartline_point(shape, s, d),
              after = heartline_point(shape, s + step, d);
  const dvec3 first = (after - before) / (2.0 * step), second = (after - 2.0 * here + before) / (step * step);
  const world::Cart* const design = document.entities.find<world::Cart>(entity);
  const world::Resistance resistance = resistance_of(document, design ? design->mass : world::kCarMass);
  const double along = acceleration_of({derived, places, 0, 0, resistance, 0, cart.drive}, cart.speed);
  const dvec3 a = along * first + cart.speed * cart.speed * second + dvec3(0, world::kGravity, 0);
  return {glm::dot(a, frame.up) / world::kGravity, glm::dot(a, frame.left()) / world::kGravity,
          glm::dot(a, frame.forward) / world::kGravity};
}

}  // namespace coaster::sim
