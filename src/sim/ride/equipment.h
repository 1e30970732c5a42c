// What stations, lifts, launches, brakes and blocks do to the trains on them: one acceleration for each tick. The same
// rules for the ride and for the ghost.
#pragma once

#include <span>
#include <vector>

#include "sim/shape/derived.h"
#include "world/motion.h"

namespace coaster::sim {

// A piece of equipment by its place along the track.
struct EquipmentSpan {
  double from = 0, to = 0;  // m from the track's start
  world::Entity segment;
  world::Equipment equipment;
};
// In track order.
std::vector<EquipmentSpan> equipment_spans(const world::Document& document, const Derived& derived);

// A train as equipment sees it.
struct TrainPlace {
  double front = 0;  // m from the track's start, of the first car
  int cars = 1;
  double spacing = 3;                 // m
  double length = world::kCarLength;  // m, of a car
};

// Parts of a train's control that last from tick to tick (members of world::CartMotion).
struct ControlState {
  std::int32_t dwell = 0;  // ticks left to wait; -1: let out
  bool braking = false;
};

struct Drive {
  double acceleration = 0;  // m/s^2 during the tick
  bool held = false;        // stands still in this tick, by station, block or ratchet
};

struct Rails {
  double length = 0;  // m
  bool closed = false;
};

// The drive of the next tick of `dt` seconds. `free` is the acceleration of gravity and losses at its start; `way_free`
// says whether the section after a station or block on which the train stands is free. Changes `state`.
Drive drive_of(std::span<const EquipmentSpan> spans, const Rails& rails, const TrainPlace& train, double speed,
               double free, bool way_free, double dt, ControlState& state);

// Whether no other train is between the end of the station or block that `train` is on and the end of the next one;
// true when it is on none.
bool section_free(std::span<const EquipmentSpan> spans, const Rails& rails, const TrainPlace& train,
                  std::span<const TrainPlace> others);

// Whether two trains overlap: any two of their cars' bodies.
bool collide(const Rails& rails, const TrainPlace& a, const TrainPlace& b);

}  // namespace coaster::sim
