// Position and orientation of cars, and the forces on their riders.
#include <algorithm>
#include <cmath>

#include "base/check.h"
#include "sim/ride/ride_parts.h"
#include "sim/shape/frame_methods.h"
#include "sim/shape/rails.h"

namespace coaster::sim {
namespace {

// Returns a train's acceleration along the rails, m/s^2, with losses and the last tick's equipment.
double along_rails(const world::Document& document, const Derived& derived, world::Entity entity,
                   const world::CartMotion& cart, std::span<const TrackPlace> places) {
  const world::Cart* const design = document.entities.find<world::Cart>(entity);
  const world::Resistance resistance = resistance_of(document, design ? design->mass : world::kCarMass);
  return acceleration_of({derived, places, 0, 0, resistance, 0, cart.drive}, cart.speed);
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
  return {rails_at(shape, s) + (place.s - s) * at.frame.forward, at.frame, at.defined};
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
  const SegmentShape& shape = derived.shape_at(place.index);
  const double s = std::clamp(place.s, 0.0, shape.arc.length());
  const double t = shape.arc.parameter(s);
  const FeltEntry here = felt_entry(shape, s, t, frame_at(shape, s, t), world::riders_height(document));
  const double along = along_rails(document, derived, entity, cart, places);
  const glm::vec3 g = here.felt(static_cast<float>(along / world::kGravity),
                                static_cast<float>(cart.speed * cart.speed / world::kGravity));
  return {g.z, g.y, g.x};
}

Rolling rolling(const world::Document& document, const Derived& derived, world::Entity entity,
                const world::CartMotion& cart, int car) {
  const std::vector<TrackPlace> places = places_of(document, derived, entity, cart);
  COASTER_CHECK(car >= 0 && static_cast<std::size_t>(car) < places.size(), "the train has this car");
  const TrackPlace place = places[static_cast<std::size_t>(car)];
  const SegmentShape& shape = derived.shape_at(place.index);
  if (!(place.s >= 0 && place.s <= shape.arc.length())) return {};  // on the straight continuation of an open end
  const double spin = shape.roll.spin(place.s), v = cart.speed;
  return {spin * v, shape.roll.slope(place.s) * v * v + spin * along_rails(document, derived, entity, cart, places)};
}

}  // namespace coaster::sim
