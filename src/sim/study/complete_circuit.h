// Completes a circuit: up to three different ways from the track's open end to its first knot, with curvature and spin
// continuous at both joints, clear of other track and within the limits of what riders feel (docs/elements.md).
#pragma once

#include <array>
#include <tuple>
#include <vector>

#include "base/cached_value.h"
#include "sim/plan/closing_candidates.h"
#include "sim/plan/element_plan.h"
#include "sim/ride/simulated_ride.h"
#include "sim/solids/conflicts.h"

namespace coaster::sim {

// --- Clearance of an element of the palette at the end of the track

// Returns points of the rails, `rails` m above an ideal curve, at least kConflictStep apart along it, both ends
// included.
std::vector<LinePoint> line_of(const ElementCurve& curve, double rails);

// The parts of a plan whose rails, on or below its ideal curve, conflict with track or with themselves; cached while
// plan and track are unchanged.
class ElementClearance {
 public:
  // `conflicts` must be up to date with `derived`; `rails` as world::rails_height().
  const std::vector<LineConflict>& update(const ElementPlan& plan, const Conflicts& conflicts,
                                          const DerivedTrack& derived, double rails);

 private:
  std::uint64_t plan_ = 0, build_ = 0;
  double rails_ = 0;
  std::vector<world::Entity> order_;
  std::vector<LineConflict> found_;
};

inline constexpr std::size_t kMostProposals = 3;

struct CircuitProposal {
  // Its last knot is the track's first, with the new incoming handle.
  ElementPlan plan;
  FeltRange felt;              // g, at the speeds that follow from the energy
  world::ClosingPlan closing;  // from which it can be planned again
};

struct CircuitProposals {
  std::vector<CircuitProposal> list;  // best first: by length and felt g
  std::string refusal;                // why there is none; empty if there is one
  double speed = 0;                   // m/s at the open end
  bool assumed = false;               // the speed is assumed: no train reaches the open end
};

// Returns the task of completing the track: `ride` is the train's simulated ride on the open track, null without a
// train. `derived` must be the document's. Nothing for a closed track and one without a segment.
std::optional<CircuitTask> circuit_task(const world::Document& document, const DerivedTrack& derived,
                                        const SimulatedRide* ride);

// Returns the proposals. `conflicts` and `derived` must be up to date for the open track. Tries at most kMostTried
// candidates: below 1 s. Reports progress; once it is cancelled, ends soon with any result.
CircuitProposals complete_circuit(const CircuitTask& task, const DerivedTrack& derived, const Conflicts& conflicts);
inline constexpr int kMostTried = 1200;
// An existing closing section, with the lengths of its spans, m.
struct FormerClosing {
  world::ClosingPlan closing;
  std::vector<double> lengths;
};
// Returns at most one closing section: the one most similar to a former one, in spans of about the same lengths. Tries
// at most kMostTriedAgain candidates: about 10 ms, and 50 ms if all fail.
CircuitProposals complete_again(const FormerClosing& former, const CircuitTask& task, const DerivedTrack& derived,
                                const Conflicts& conflicts);
inline constexpr int kMostTriedAgain = 12;

// Closes an open track by a proposal of it, whose spans become a section that completes the circuit. Returns the last
// new knot, or none if the proposal is a single span.
std::optional<world::Entity> close_by(world::Document& document, const CircuitProposal& proposal);

// The track of a circuit without the section that completes it, from that section's end to its start.
struct OpenedTrack {
  DerivedTrack derived;
  Conflicts conflicts;
  void update(const world::Document& opened);
};

// Caches the proposals while task and track are unchanged.
class ProposalCache {
 public:
  // Returns the proposals, updated; refused for a track that cannot be completed.
  const CircuitProposals& update(const world::Document& document, const DerivedTrack& derived,
                                 const Conflicts& conflicts, const SimulatedRide* ride);
  const CircuitProposals& found() const { return found_; }  // of the last update, for tests

 private:
  std::optional<CircuitTask> task_;
  std::uint64_t build_ = 0, serial_ = 0;
  std::vector<world::Entity> order_;
  CircuitProposals found_;
};

// Caches the jolts of the proposals and the tables of the last closed track.
class ClosingJolts {
 public:
  // Returns the largest total jolt at the proposal's joints, with both ends of the open track, for all cars of the
  // train on a whole ride, low-passed by `cutoff` (Hz), g; 0 if the train does not arrive. `serial` changes with the
  // open track. The first call for a proposal costs a simulated ride.
  double worst(const CircuitProposals& found, std::size_t index, const world::Document& open, std::uint64_t serial,
               world::Entity cart, double cutoff);

 private:
  using Key = std::tuple<std::uint64_t, std::uint64_t, world::Entity, double>;
  std::array<base::CachedValue<Key, double>, kMostProposals> kept_;
  DerivedTrack closed_;
  RideCache rides_;
};

}  // namespace coaster::sim
