// The state of a ghost's train where it passes a position.
#pragma once

#include <optional>
#include <vector>

#include "sim/ride/ghost.h"

namespace coaster::sim {

struct Passing {
  double speed = 0, along = 0;  // m/s, negative backwards; m/s^2 along the track
};

// Returns true if a ride goes farther backwards than forwards.
bool runs_backwards(const Ghost& ride);

// Looks up many positions of one ride. Valid as long as the ghost.
class Passings {
 public:
  explicit Passings(const Ghost& ride);
  // Returns the state when the point `back` m behind the first car first passes `distance` m from the track's start;
  // nothing if it does not. v^2 between two samples, or a sample and an instant where equipment switches, is the cubic
  // of the way with their speeds and accelerations: within 2e-6 m/s of the energy's.
  std::optional<Passing> at(double distance, double back = 0) const;

 private:
  const Ghost& ride_;
  bool backwards_;
  std::vector<double> furthest_;  // by sample: how far it has been until then, in that direction
};

// Returns the state at the first car's first pass; nothing if the ride does not reach the position.
inline std::optional<Passing> passing(const Ghost& ride, double distance) { return Passings(ride).at(distance); }

}  // namespace coaster::sim
