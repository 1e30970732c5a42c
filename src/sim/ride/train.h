// A train on the rails: where its cars are, and what pulls it along. One speed and one energy for the whole train; cars
// of equal mass.
#pragma once

#include <span>
#include <vector>

#include "sim/shape/derived.h"
#include "world/motion.h"

namespace coaster::sim {

// A point of the rails as an integrator sees it.
struct RailPoint {
  double height;  // m (y)
  double slope;   // dy/ds, the tangent's y
};
// At arc length s of a segment; beyond its ends the rails go on straight.
RailPoint rail_point(const SegmentShape& shape, double s);

// The middle of a car: a segment by its place in derived.order, and the arc length within it. Cars that hang over the
// end of an open track have s beyond [0, length] of its first or last segment.
struct CarPlace {
  std::size_t index = 0;
  double s = 0;  // m
};

// How many of a designed train's cars find room: all, but on a closed track no more than it is long.
int cars_on(const Derived& derived, const world::Cart& design);

// The place `back` metres behind (negative: ahead of) another, over as many joints as lie between.
CarPlace behind(const Derived& derived, CarPlace place, double back);

// A document's losses as one train feels them: drag per kilogram goes with 1 / mass.
world::Resistance resistance_of(const world::Document& document, double car_mass);

// The cars of a train, first to last, from the place of its first car.
void place_cars(const Derived& derived, CarPlace front, int cars, double spacing, std::vector<CarPlace>& places);

// A train during a part of a tick in which no car crosses a joint. x is how far it has moved since the part began, m.
struct TrainState {
  double x = 0;
  double speed = 0;  // m/s
  double work = 0;   // J/kg done by what is not gravity
};
struct TrainContext {
  const Derived& derived;
  std::span<const CarPlace> cars;  // at x = 0
  double datum = 0;                // m
  double reference_energy = 0;     // J/kg, the work so far included
  world::Resistance resistance;
  double direction = 0;  // sign of the motion that losses oppose: +1, -1, or 0 at rest
  double drive = 0;      // m/s^2 by equipment, the same during a tick
  bool across = false;   // x may go over joints; else the rails go on straight there

  CarPlace moved(const CarPlace& car, double x) const {
    return across ? behind(derived, car, -x) : CarPlace{car.index, car.s + x};
  }
  double height(double x) const;   // m, the cars' mean
  double gravity(double x) const;  // m/s^2 along the rails: -g times the cars' mean slope
  // m/s^2 by losses and equipment.
  double others(double speed) const {
    return drive - direction * (world::kGravity * resistance.rolling + resistance.drag * speed * speed);
  }
};

// Where x first reaches the joint that some car will cross: +infinity, -infinity where there is none (no cars).
double joint_ahead(const TrainContext& context);
double joint_behind(const TrainContext& context);

}  // namespace coaster::sim
