// A train on the rails: the positions of its cars and the forces on it. One speed and one energy for the whole train;
// cars of equal mass.
#pragma once

#include <span>
#include <vector>

#include "sim/shape/derived.h"
#include "world/motion.h"

namespace coaster::sim {

// A point of the rails, as integrators use it.
struct RailPoint {
  double height;  // m (y)
  double slope;   // dy/ds, the tangent's y
};
// Returns the point at arc length s of a segment; beyond its ends the rails continue straight.
RailPoint rail_point(const SegmentShape& shape, double s);

// The middle of a car: the index of its segment in derived.order, and the arc length within it. Cars beyond the end of
// an open track have s outside [0, length] of its first or last segment.
struct CarPlace {
  std::size_t index = 0;
  double s = 0;  // m
};

// Returns how many of a designed train's cars fit on the track: all, but on a closed track no more than its length
// allows.
int cars_on(const Derived& derived, const world::Cart& design);

// Returns the position `back` metres behind another (negative: ahead), across any number of joints.
CarPlace behind(const Derived& derived, CarPlace place, double back);

// Returns a document's losses for one train: drag per kilogram is proportional to 1 / mass.
world::Resistance resistance_of(const world::Document& document, double car_mass);

// Writes the positions of a train's cars, first to last, from that of its first car.
void place_cars(const Derived& derived, CarPlace front, int cars, double spacing, std::vector<CarPlace>& places);

// A train during a part of a tick in which no car crosses a joint. x is the distance moved since the part began, m.
struct TrainState {
  double x = 0;
  double speed = 0;  // m/s
  double work = 0;   // J/kg done by everything except gravity
};
struct TrainContext {
  const Derived& derived;
  std::span<const CarPlace> cars;  // at x = 0
  double datum = 0;                // m
  double reference_energy = 0;     // J/kg, including the work so far
  world::Resistance resistance;
  double direction = 0;  // sign of the motion that losses oppose: +1, -1, or 0 at rest
  double drive = 0;      // m/s^2 by equipment, constant during a tick
  bool across = false;   // x may cross joints; else the rails continue straight there

  CarPlace moved(const CarPlace& car, double x) const {
    return across ? behind(derived, car, -x) : CarPlace{car.index, car.s + x};
  }
  double height(double x) const;   // m, the cars' mean
  double gravity(double x) const;  // m/s^2 along the rails: -g times the cars' mean slope
  // Returns the acceleration in m/s^2 by losses and equipment.
  double others(double speed) const {
    return drive - direction * (world::kGravity * resistance.rolling + resistance.drag * speed * speed);
  }
};

// Returns the x at which a car first reaches a joint: +infinity or -infinity if there is none (no cars).
double joint_ahead(const TrainContext& context);
double joint_behind(const TrainContext& context);

}  // namespace coaster::sim
