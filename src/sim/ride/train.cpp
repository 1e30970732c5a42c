#include "sim/ride/train.h"

#include <limits>

namespace coaster::sim {
namespace {

double length_of(const DerivedTrack& derived, std::size_t index) { return derived.shape_at(index).arc.length(); }

double sum_over_cars(const TrainContext& train, double x, double RailPoint::*value) {
  double sum = 0;
  for (const TrackPlace& car : train.cars) {
    const TrackPlace at = train.moved(car, x);
    sum += rail_point(train.derived.shape_at(at.index), at.s).*value;
  }
  return sum;
}

}  // namespace

RailPoint rail_point(const SegmentShape& shape, double s) {
  const double length = shape.arc.length();
  const double t = shape.arc.parameter(s);
  const double slope = curve::unit_tangent(shape.key.cubic, t).y;
  const double height = curve::point(shape.key.cubic, t).y;
  if (s < 0) return {height + s * slope, slope};
  if (s > length) return {height + (s - length) * slope, slope};
  return {height, slope};
}

int cars_on(const DerivedTrack& derived, const world::Train& design) {
  if (!derived.closed) return design.cars;
  const double room = derived.length / design.spacing;
  return std::clamp(static_cast<int>(std::min(room, 1e6)), 1, static_cast<int>(design.cars));
}

world::Losses resistance_of(const world::Document& document, double car_mass) {
  world::Losses felt = document.resistance;
  if (car_mass != world::kCarMass) felt.drag = static_cast<float>(felt.drag * world::kCarMass / car_mass);
  return felt;
}

TrackPlace behind(const DerivedTrack& derived, TrackPlace place, double back) {
  const std::size_t count = derived.order.size();
  place.s -= back;
  // A track of only zero-length segments has no point farther back.
  for (std::size_t joints = 0; joints < 4 * count; ++joints) {
    if (place.s < 0) {
      if (place.index == 0 && !derived.closed) return place;
      place.index = place.index == 0 ? count - 1 : place.index - 1;
      place.s += length_of(derived, place.index);
    } else if (place.s > length_of(derived, place.index)) {
      if (place.index + 1 == count && !derived.closed) return place;
      place.s -= length_of(derived, place.index);
      place.index = place.index + 1 == count ? 0 : place.index + 1;
    } else {
      return place;
    }
  }
  return {place.index, 0.0};
}

void place_cars(const DerivedTrack& derived, TrackPlace front, int cars, double spacing,
                std::vector<TrackPlace>& places) {
  places.resize(static_cast<std::size_t>(cars));
  places[0] = front;
  for (std::size_t i = 1; i < places.size(); ++i) places[i] = behind(derived, places[i - 1], spacing);
}

double TrainContext::height(double x) const {
  return sum_over_cars(*this, x, &RailPoint::height) / static_cast<double>(cars.size());
}

double TrainContext::gravity(double x) const {
  return -world::kGravity * sum_over_cars(*this, x, &RailPoint::slope) / static_cast<double>(cars.size());
}

double joint_ahead(const TrainContext& context) {
  double least = std::numeric_limits<double>::infinity();
  for (const TrackPlace& car : context.cars) {
    const double left = length_of(context.derived, car.index) - car.s;
    if (left >= 0) least = std::min(least, left);  // a car beyond an open end has its last joint behind it
  }
  return least;
}

double joint_behind(const TrainContext& context) {
  double most = -std::numeric_limits<double>::infinity();
  for (const TrackPlace& car : context.cars)
    if (car.s >= 0) most = std::max(most, -car.s);
  return most;
}

}  // namespace coaster::sim
