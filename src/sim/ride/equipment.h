// The effect of stations, lifts, launches, brakes and blocks on trains. It changes at instants within a tick: where a
// car comes to an end of equipment or the train reaches a speed. The ride and the simulated ride use the same rules,
// and find the instants by time_of() (train.h).
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "sim/shape/derived_track.h"
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
std::vector<EquipmentSpan> equipment_spans(const world::Document& document, const DerivedTrack& derived);

// The data of a train that equipment uses.
struct TrainPlace {
  double front = 0;  // m from the track's start, of the first car
  int cars = 1;
  double spacing = 3;                 // m
  double length = world::kCarLength;  // m, of a car
};

// The control state of a train between ticks (members of world::TrainMotion).
struct ControlState {
  std::int32_t dwell = 0;  // ticks left to wait; -1: dispatched
  bool braking = false;
  friend bool operator==(const ControlState&, const ControlState&) = default;
};

struct TrackExtent {
  double length = 0;  // m
  bool closed = false;
};

// The equipment that a train is on.
struct EquipmentContact {
  const EquipmentSpan* span;
  double share;  // of the cars that are on it
  bool front;    // the first car is
};
// That of all spans, and how far the train can move until it changes: -behind..ahead m. A car on a border counts as
// past it, in the direction of the motion.
struct Contacts {
  std::vector<EquipmentContact> on;
  double behind = 0, ahead = 0;
  bool back = false;  // the train moves backwards
};
Contacts contacts_of(std::span<const EquipmentSpan> spans, const TrackExtent& rails, const TrainPlace& train,
                     bool back);

// The contacts of a moving train, updated when they change. `at` is how far it has moved from any point, m.
class TrainContacts {
 public:
  const Contacts& update(std::span<const EquipmentSpan> spans, const TrackExtent& rails, const TrainPlace& train,
                         double at, bool back);
  // Return where they change next, as `at`.
  double ahead() const { return at_ + contacts_.ahead; }
  double behind() const { return at_ - contacts_.behind; }

 private:
  Contacts contacts_;
  double at_ = 0;
};

// What equipment does to a train until it switches.
struct Drive {
  double acceleration = 0;  // m/s^2, added to gravity and losses; with `net` the train's own, whatever these are
  bool net = false;
  bool held = false;  // does not move: held by a station, block or ratchet
  friend bool operator==(const Drive&, const Drive&) = default;
};

struct TrainMoment {
  double front = 0;                     // m from the track's start, of the first car, within the lap
  double speed = 0;                     // m/s
  const std::function<double()>& free;  // m/s^2 by gravity and losses
  double step = 0;  // s: of a train that is driven by whole steps, which reaches speeds within one step only
};

// A train's switches in one tick that are timed; from then on its drive holds to the tick's end. Only brakes whose
// hysteresis is next to nothing get there.
inline constexpr int kMostSwitches = 16;
inline constexpr double kSwitchWithin = 1e-12;  // s

// Returns the drive from this moment on; it holds until it would return another one or another state. `way_free` says
// whether the section after the train's station or block is free. Updates `state`.
Drive drive_of(const Contacts& contacts, const TrainPlace& train, const TrainMoment& now, bool way_free,
               ControlState& state);

// Counts a tick of a train that waits, at the tick's start, and dispatches it.
void count_down(bool way_free, ControlState& state);

// True if no other train is between the end of the station or block that `train` is on and the end of the next one;
// also true if it is on none.
bool section_free(std::span<const EquipmentSpan> spans, const TrackExtent& rails, const TrainPlace& train,
                  std::span<const TrainPlace> others);

// Returns a warning if a closed track has no more block sections, one for each station and block, than trains, so that
// all will wait for ever; empty if it has more, or no blocks, or one train.
std::string deadlock_text(const world::Document& document, const DerivedTrack& derived);

// True if two trains overlap: the bodies of any two of their cars.
bool collide(const TrackExtent& rails, const TrainPlace& a, const TrainPlace& b);

// Returns the lowest index of a train that overlaps one with a higher index; nothing if none do. Trains whose entry in
// `left_out` is not zero do not count. Sorts them along the track: n log n for n trains.
std::optional<std::size_t> first_collision(const TrackExtent& rails, std::span<const TrainPlace> trains,
                                           std::span<const char> left_out);

}  // namespace coaster::sim
