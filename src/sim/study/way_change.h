// Keeps a circuit closed after a change of its track: plans its way home again.
#pragma once

#include <string>
#include <vector>

#include "sim/study/complete_circuit.h"

namespace coaster::sim {

// What the change asks for. A plain value, so that any thread can search on it.
struct WayChange {
  world::Document opened;       // the changed circuit without its way home, from that way's end to its start
  world::WayHome former;        // the way before the change
  std::vector<double> lengths;  // m, of its spans
  double risen = 0;             // m, by which its start has risen since, as far as the train coasts
  world::Resistance losses;     // of the train
  bool whole = true;            // searches all ways home if none is like the former one
  friend bool operator==(const WayChange&, const WayChange&) = default;
};

struct ChangedWay {
  ElementFit fit;  // its last knot is the circuit's knot after the way, with a new incoming handle
  world::WayHome way;
  bool another = false;  // it was found by searching all ways home
  std::string refusal;   // why there is none; empty if there is one
};

// Returns the way that is most similar to the former one, planned for its speed, adjusted by the height that its start
// has gained. The same bits everywhere. Takes about 10 ms, and below 1 s if it searches all ways home. `opened` caches
// shapes and conflicts of the opened track. Reports progress; once it is cancelled, ends soon with any result.
ChangedWay changed_way(const WayChange& change, OpenedTrack& opened);

}  // namespace coaster::sim
