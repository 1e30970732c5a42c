// Keeps a circuit closed after a change of its track: plans its closing section again.
#pragma once

#include <string>
#include <vector>

#include "sim/study/complete_circuit.h"

namespace coaster::sim {

// What the change asks for. A plain value, so that any thread can search on it.
struct ClosingReplanTask {
  world::Document opened;       // the changed circuit without its closing section, from that section's end to its start
  world::ClosingPlan former;    // the way before the change
  std::vector<double> lengths;  // m, of its spans
  double risen = 0;             // m, by which its start has risen since, as far as the train coasts
  world::Losses losses;         // of the train
  bool whole = true;            // searches all closing sections if none is like the former one
  friend bool operator==(const ClosingReplanTask&, const ClosingReplanTask&) = default;
};

struct ClosingReplanResult {
  ElementFit fit;  // its last knot is the circuit's knot after the section, with a new incoming handle
  world::ClosingPlan closing;
  bool another = false;  // it was found by searching all closing sections
  std::string refusal;   // why there is none; empty if there is one
};

// Returns the one that is most similar to the former one, planned for its speed, adjusted by the height that its start
// has gained. The same bits everywhere. Takes about 10 ms, and below 1 s if it searches all closing sections. `opened`
// caches shapes and conflicts of the opened track. Reports progress; once it is cancelled, ends soon with any result.
ClosingReplanResult changed_closing(const ClosingReplanTask& change, OpenedTrack& opened);

}  // namespace coaster::sim
