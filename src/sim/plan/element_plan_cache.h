// The last plan of an element of the palette.
#pragma once

#include <optional>

#include "sim/plan/element_plan.h"
#include "sim/plan/force_path.h"

namespace coaster::sim {

// Caches the last plan while the element, the track's end and, for a force element, the train are unchanged.
class ElementCache {
 public:
  const ElementPlan& plan(const world::Element& element, const world::Document& document,
                          std::optional<double> speed = std::nullopt);

 private:
  std::optional<world::Element> element_;
  std::optional<TrackEnd> end_;
  std::optional<double> speed_;
  std::optional<ForceTask> train_;
  ElementPlan plan_;
};

}  // namespace coaster::sim
