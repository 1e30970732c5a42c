// Shared by the files of the ride. Not for other rooms.
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "sim/ride/ride.h"

namespace coaster::sim {

struct RideInput {
  const world::Document& document;
  const Derived& derived;
  std::span<const EquipmentSpan> equipment;
};

TrackPlace front_place(const Derived& derived, const world::CartMotion& cart);
// Returns the positions of a moving train's cars, first to last.
std::vector<TrackPlace> places_of(const world::Document& document, const Derived& derived, world::Entity entity,
                                  const world::CartMotion& motion);
// Returns a train's acceleration along the rails at x = 0 and this speed.
double acceleration_of(TrainContext context, double speed);
// Stops a train at its position; the energy removed counts as work.
void halt(world::CartMotion& cart);
// Writes position, length and distance to the motion.
void settle_on(const Derived& derived, TrackPlace front, world::CartMotion& cart);

// What equipment needs to know of a train during a tick.
struct Control {
  TrainContacts contacts;
  ControlState state;
  bool way_free = true;
  Drive drive;  // the last one
};

struct TickContext {
  const RideInput& input;
  const Integrator& row;
  world::Resistance resistance;  // of the current train
  TrainPlace train;              // its cars
  Control& control;
};

// Updates the drive of a train in its present state. Returns the equipment that it is on.
const Contacts& update_drive(const TickContext& tick, const TrainContext& context, const world::CartMotion& cart);
// Advances a train by `dt` in parts that end at joints, where equipment switches and where losses stop it. Returns
// false at an open end.
bool advance_stepped(const TickContext& tick, double dt, std::vector<TrackPlace>& places, world::CartMotion& cart);

// Advances all trains by whole ticks while the ride is running, by a stepped row or by vertices.
void step_trains(const RideInput& input, const Integrator& row, int ticks, world::Motion& motion);

// Advances by the timetable that starts where the train was when this integrator took over (cart.timetable): one entry
// per tick. When it ends, another one starts there. More than kMostTimetables trains share tables: those of one kind
// and energy move alike on a circuit without losses and equipment, each at its own time of the lap. Returns false, and
// moves nothing, if there would still be more tables than that, or if laps do not repeat.
inline constexpr std::size_t kMostTimetables = 64;
bool step_by_timetable(const RideInput& input, int ticks, GhostMemo& memo, world::Motion& motion);

// Returns the start of a train's timetable at its present motion.
world::TimetablePlace timetable_from(const world::CartMotion& cart);
GhostStart start_of(const RideInput& input, world::Entity entity, const world::TimetablePlace& table);

// The tables of one lap for many trains, each looked up in the memo once.
class LapTables {
 public:
  LapTables(const RideInput& input, GhostMemo& memo) : input_(input), memo_(memo) {}
  const LapTable& of(world::Entity entity, const world::TimetablePlace& place);
  // Returns that of each train, in the order of the items.
  std::vector<const LapTable*> of(const world::Pool<world::CartMotion>& carts);

 private:
  const RideInput& input_;
  GhostMemo& memo_;
  std::vector<std::pair<GhostStart, const LapTable*>> tables_;  // at most kMostTimetables
};

// If a train is without a timetable, gives each the one of its kind and energy. Returns false if there are too many, or
// if a train may not complete a lap.
bool share_timetables(const RideInput& input, GhostMemo& memo, world::Motion& motion);
// Runs all ticks of those `trains` (indices of `carts` and of their tables) whose laps repeat.
void follow_laps(const RideInput& input, std::span<const LapTable* const> table_of, std::span<const std::size_t> trains,
                 int ticks, std::vector<world::CartMotion>& carts);

// The data of a train for integrators without a TrainContext.
struct TrainLoad {
  int cars = 1;
  double spacing = 3;            // m
  world::Resistance resistance;  // for this train's mass
  double drive = 0;              // m/s^2 by equipment
};

// Advances by the paper's conclusion: from vertex to vertex of the polyline, each chord / speed after the last. The
// speed follows from the energy at the vertex, with the cars' mean height, losses and equipment. A train at rest stays,
// as in the paper, unless equipment pushes it. The remaining time is kept in cart.carry. Returns false at an open end.
bool advance_by_vertices(const RideInput& input, const TrainLoad& load, double dt, world::CartMotion& cart);

}  // namespace coaster::sim
