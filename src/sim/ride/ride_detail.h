// Shared by the files of the ride.
#pragma once

#include <span>

#include "sim/ride/ride.h"

namespace coaster::sim {

struct RideInput {
  const world::Document& document;
  const DerivedTrack& derived;
  std::span<const EquipmentSpan> equipment;
};

TrackPlace front_place(const DerivedTrack& derived, const world::TrainMotion& cart);
// Returns a train's acceleration along the rails at x = 0 and this speed.
double acceleration_of(TrainContext context, double speed);
// Stops a train at its position; the energy removed counts as work.
void halt(world::TrainMotion& cart);
// Writes position, length and distance to the motion.
void settle_on(const DerivedTrack& derived, TrackPlace front, world::TrainMotion& cart);

// Advances all trains by whole ticks while the ride is running, by a stepped row or by vertices.
void step_trains(const RideInput& input, const Integrator& row, int ticks, world::Motion& motion);

// Advances by the timetable that starts where the train was when this integrator took over (cart.timetable): one entry
// per tick. When it ends, another one starts there. More than kMostTimetables trains share tables: those of one kind
// and energy move alike on a circuit without losses and equipment, each at its own time of the lap. Returns false, and
// moves nothing, if there would still be more tables than that, or if laps do not repeat.
inline constexpr std::size_t kMostTimetables = 64;
bool step_by_timetable(const RideInput& input, int ticks, RideCache& cache, world::Motion& motion);

}  // namespace coaster::sim
