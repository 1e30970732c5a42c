// The jolt of a way home: what riders would feel at its joints (jolt.h) if the track were closed by it.
#pragma once

#include <array>
#include <tuple>

#include "base/kept.h"
#include "sim/study/complete_circuit.h"

namespace coaster::sim {

// Caches the jolts of the proposals and the tables of the last closed track.
class WayJolts {
 public:
  // Returns the largest total jolt at the proposal's joints, with both ends of the open track, for all cars of the
  // train on a whole ride, low-passed by `cutoff` (Hz), g; 0 if the train does not arrive. `serial` changes with the
  // open track. The first call for a proposal costs a simulated ride.
  double worst(const CircuitProposals& found, std::size_t index, const world::Document& open, std::uint64_t serial,
               world::Entity cart, double cutoff);

 private:
  using Key = std::tuple<std::uint64_t, std::uint64_t, world::Entity, double>;
  std::array<base::Kept<Key, double>, kMostProposals> kept_;
  Derived closed_;
  GhostMemo rides_;
};

}  // namespace coaster::sim
