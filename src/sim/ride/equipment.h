// The effect of stations, lifts, launches, brakes and blocks on trains: one acceleration per tick. The ride and the
// ghost use the same rules.
#pragma once

#include <span>
#include <vector>

#include "sim/shape/derived.h"
#include "world/motion.h"

namespace coaster::sim {

// A piece of equipment and its position along the track.
struct EquipmentSpan {
  double from = 0, to = 0;  // m from the track's start
  world::Entity segment;
  world::Equipment equipment;
  friend bool operator==(const EquipmentSpan&, const EquipmentSpan&) = default;
};
// Returns the spans in track order. Neighbouring segments of one section that are equal stations form one span, at
// whose end trains stop once.
std::vector<EquipmentSpan> equipment_spans(const world::Document& document, const Derived& derived);

// The data of a train that equipment uses.
struct TrainPlace {
  double front = 0;  // m from the track's start, of the first car
  int cars = 1;
  double spacing = 3;                 // m
  double length = world::kCarLength;  // m, of a car
};

// The control state of a train between ticks (members of world::CartMotion).
struct ControlState {
  std::int32_t dwell = 0;  // ticks left to wait; -1: dispatched
  bool braking = false;
  friend bool operator==(const ControlState&, const ControlState&) = default;
};

struct Drive {
  double acceleration = 0;  // m/s^2 during the tick
  bool held = false;        // does not move in this tick: held by a station, block or ratchet
};

struct Rails {
  double length = 0;  // m
  bool closed = false;
};

// Returns the drive of the next tick of `dt` seconds. `free` is the acceleration by gravity and losses at its start;
// `way_free` says whether the section after the train's station or block is free. Updates `state`.
Drive drive_of(std::span<const EquipmentSpan> spans, const Rails& rails, const TrainPlace& train, double speed,
               double free, bool way_free, double dt, ControlState& state);

// True if no other train is between the end of the station or block that `train` is on and the end of the next one;
// also true if it is on none.
bool section_free(std::span<const EquipmentSpan> spans, const Rails& rails, const TrainPlace& train,
                  std::span<const TrainPlace> others);

// True if two trains overlap: the bodies of any two of their cars.
bool collide(const Rails& rails, const TrainPlace& a, const TrainPlace& b);

// Returns the lowest index of a train that overlaps one with a higher index; nothing if none do. Trains whose entry in
// `left_out` is not zero do not count. Sorts them along the track: n log n for n trains.
std::optional<std::size_t> first_collision(const Rails& rails, std::span<const TrainPlace> trains,
                                           std::span<const char> left_out);

}  // namespace coaster::sim
