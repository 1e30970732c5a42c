// A ride as the riders of one seat feel it: curves along the track or over time, values at a place, largest values.
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

// Curves along a ride. Of several cars: the smallest and the largest value; of one car `most` is empty.
struct SeatCurves {
  std::vector<double> place, time;  // of the middle one of the cars: m as by Rider::place, s since the start
  std::array<std::vector<double>, kRideValueCount> least, most;
};
// By place: each car's value when it first comes to that place, so `place` ascends even where the train stands, rolls
// back or starts backwards. Places of a closed track are equal one lap apart. A car that does not come to a place does
// not count there.
SeatCurves curves_by_place(std::span<const Rider> riders);
// By time: all cars at the same moment. `time` ascends.
SeatCurves curves_by_time(std::span<const Rider> riders);

// Returns the car's value when it first comes to a distance along the track (m), linear between entries; nothing if it
// does not come there.
std::optional<double> value_at(const Rider& rider, double distance, RideValue value);

// Returns the value that is largest in magnitude, of all these cars; with its sign.
Extreme most_of(std::span<const Rider> riders, RideValue value);

}  // namespace coaster::sim
