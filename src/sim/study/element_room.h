// Whether an element of the palette would have room at the end of the track.
#pragma once

#include <vector>

#include "sim/plan/elements.h"
#include "sim/solids/conflicts.h"

namespace coaster::sim {

// Where the plan's ideal curve would be in the way of track or of itself; kept while plan and track are the same.
class ElementRoom {
 public:
  // `conflicts` has been brought up to date with `derived`.
  const std::vector<Narrow>& update(const ElementPlan& plan, const Conflicts& conflicts, const Derived& derived);

 private:
  std::uint64_t plan_ = 0, build_ = 0;
  std::vector<world::Entity> order_;
  std::vector<Narrow> found_;
};

}  // namespace coaster::sim
