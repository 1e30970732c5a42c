// What the files of the ride share. Not for other rooms.
#pragma once

#include <span>

#include "sim/ride/equipment.h"
#include "sim/ride/ride.h"

namespace coaster::sim {

struct RideInput {
  const world::Document& document;
  const Derived& derived;
  std::span<const EquipmentSpan> equipment;
};

CarPlace front_place(const Derived& derived, const world::CartMotion& cart);
// Brings a train to rest where it is; the energy that this takes counts as work.
void halt(world::CartMotion& cart);
// Writes place, length and distance into the motion.
void settle_on(const Derived& derived, CarPlace front, world::CartMotion& cart);

// Advances all trains by whole ticks while the ride is running, by a stepped row or by vertices.
void step_trains(const RideInput& input, const Integrator& row, int ticks, world::Motion& motion);

// By the timetable that starts where the train was when this integrator took over (cart.timetable): at each tick its
// entry. When it ends, another one starts there.
void step_by_timetable(const RideInput& input, int ticks, GhostMemo& memo, world::Motion& motion);

// What an integrator without a TrainContext has to know of a train.
struct TrainLoad {
  int cars = 1;
  double spacing = 3;            // m
  world::Resistance resistance;  // as this train feels it
  double drive = 0;              // m/s^2 by equipment
};

// The paper's conclusion: from vertex to vertex of the polyline, each chord / speed after the last, the speed by the
// energy at the vertex: of the cars' mean height, less what losses took and with what equipment gave on the way. At
// rest it stays, as the paper's does, unless equipment pushes. The time that is left waits in cart.carry. False at an
// open end.
bool advance_by_vertices(const RideInput& input, const TrainLoad& load, double dt, world::CartMotion& cart);

}  // namespace coaster::sim
