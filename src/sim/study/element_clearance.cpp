#include "sim/study/element_clearance.h"

#include <algorithm>

namespace coaster::sim {

std::vector<LinePoint> line_of(const ElementCurve& curve, double rails) {
  constexpr double kMostChords = 600;
  const double step = std::max(kConflictStep, curve.length() / kMostChords);
  std::vector<LinePoint> line;
  for (const ElementPoint& p : curve.points)
    if (line.empty() || p.s >= double{line.back().s} + step || &p == &curve.points.back())
      line.push_back({glm::vec3(p.position + rails * p.up), glm::vec3(p.up), static_cast<float>(p.s)});
  return line;
}

const std::vector<LineConflict>& ElementClearance::update(const ElementPlan& plan, const Conflicts& conflicts,
                                                          const DerivedTrack& derived, double rails) {
  if (plan_ == plan.serial && build_ == derived.last_build && order_ == derived.order && rails_ == rails) return found_;
  plan_ = plan.serial, build_ = derived.last_build, order_ = derived.order, rails_ = rails;
  found_.clear();
  if (plan.refusal.empty()) found_ = conflicts.against(derived, line_of(plan.ideal, rails));
  return found_;
}

}  // namespace coaster::sim
