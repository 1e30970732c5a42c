// A ride as the riders of one seat feel it: curves along the track or over time, values at a position, largest values.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "sim/study/ratings.h"
#include "sim/study/riders.h"
#include "world/laboratory.h"

namespace coaster::sim {

// Returns the cars of a seat in a train of `cars` cars. `own`: the car of Seat::car, from 1; beyond the last car it is
// the last one.
CarRange cars_of(world::Seat seat, int own, int cars);

// Curves along a ride. For several cars: the smallest and the largest value; for one car `most` is empty.
struct SeatCurves {
  std::vector<double> place, time;  // position of the middle car: m as by Rider::place, s since the start
  std::array<std::vector<double>, kRideValueCount> least, most;
};
// Returns the curves by position: each car's value when it first reaches the position, so `place` ascends even if the
// train stops, rolls back or starts backwards. Positions one lap apart on a closed track are equal. A car that does not
// reach a position does not count there.
SeatCurves curves_by_place(std::span<const Rider> riders);
// Returns the curves by time: all cars at the same moment. `time` ascends.
SeatCurves curves_by_time(std::span<const Rider> riders);

// Returns the car's value when it first reaches a distance along the track (m), linear between entries but for the
// speed (Passings); nothing if it does not reach it.
std::optional<double> value_at(const Rider& rider, double distance, RideValue value);

// Returns the value with the largest magnitude of all these cars, with its sign.
Extreme most_of(std::span<const Rider> riders, RideValue value);

}  // namespace coaster::sim
