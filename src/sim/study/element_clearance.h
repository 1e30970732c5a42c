// Checks whether an element of the palette has clearance at the end of the track.
#pragma once

#include <vector>

#include "sim/plan/element_plan.h"
#include "sim/solids/conflicts.h"

namespace coaster::sim {

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

}  // namespace coaster::sim
