#include "sim/plan/elements.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/text.h"
#include "curve/continuity.h"
#include "curve/frames.h"

namespace coaster::sim {
namespace {

using glm::dvec3;

constexpr double kLongestElement = 20'000;  // m

// Clamps values to the limits of the table, with a line for each.
void clamp_values(world::Element& element, std::vector<std::string>& lines) {
  const world::ElementRow& row = base::row_of(element.kind);
  element.right = element.right && row.sided;
  for (std::size_t i = 0; i < element.values.size(); ++i) {
    double& value = element.values[i];
    if (i >= row.parameters.size()) {
      value = 0;
      continue;
    }
    const world::ElementParameter& p = row.parameters[i];
    if (!std::isfinite(value)) value = p.usual;
    const double cut = std::clamp(value, p.low, p.high);
    if (cut == value) continue;
    lines.push_back(beyond_limit(p, value, cut) + ".");
    value = cut;
  }
}

bool within_world(const ElementCurve& curve) {
  const double most = world::kMaxCoordinate;
  for (const ElementPoint& p : curve.points)
    for (int axis = 0; axis < 3; ++axis)
      if (!(std::abs(p.position[axis]) <= most)) return false;
  return true;
}

}  // namespace

std::optional<TrackEnd> open_end(const world::Document& document) {
  if (document.track.closed) return std::nullopt;
  if (document.track.knots.empty()) return TrackEnd{};
  return end_at(document, document.track.knots.size() - 1);
}

TrackEnd end_at(const world::Document& document, std::size_t knot) {
  const world::Track& track = document.track;
  TrackEnd end;
  const world::Knot& last = world::knot(document, track.knots[knot]);
  end.position = dvec3(last.position);
  end.forward = glm::normalize(dvec3(last.tangent));
  end.up = curve::perpendicular(end.forward, dvec3(last.up));
  end.spin = last.spin;
  if (knot == 0 && !track.closed) return end;
  const world::Entity before = knot == 0 ? track.segments.back() : track.segments[knot - 1];
  end.curvature = curve::across(curve::curvature_vector(world::cubic_of(document, before), 1.0), end.forward);
  return end;
}

ElementPlan plan_element(const world::Element& element, const TrackEnd& end) {
  ElementPlan plan;
  plan.element = element;
  clamp_values(plan.element, plan.lines);
  ElementShape shape = element_shape(plan.element, end, plan.lines);
  plan.refusal = std::move(shape.refusal);
  if (!plan.refusal.empty()) return plan;
  plan.ideal = std::move(shape.curve);
  plan.length = plan.ideal.length();
  plan.lead = plan.ideal.points[plan.ideal.lead].s;
  if (plan.length > kLongestElement)
    plan.refusal = fmt::format("the element is longer than the limit of {} m", base::to_text(kLongestElement));
  else if (!within_world(plan.ideal))
    plan.refusal = fmt::format("the element goes beyond the limit of coordinates, {} m",
                               base::to_text(double{world::kMaxCoordinate}));
  if (!plan.refusal.empty()) return plan;
  plan.fit = fit_element(plan.ideal);
  plan.lowest = plan.ideal.points.front().position.y;
  for (const ElementPoint& p : plan.ideal.points) plan.lowest = std::min(plan.lowest, p.position.y);
  return plan;
}

ElementPlan plan_element(const world::Element& element, const world::Document& document) {
  if (const std::optional<TrackEnd> end = open_end(document)) return plan_element(element, *end);
  ElementPlan plan;
  plan.element = element;
  clamp_values(plan.element, plan.lines);
  plan.refusal = "the track is closed: open it first";
  return plan;
}

const ElementPlan& ElementMemo::plan(const world::Element& element, const world::Document& document) {
  const std::optional<TrackEnd> end = open_end(document);
  if (element_ == element && end_ == end) return plan_;
  const std::uint64_t serial = plan_.serial + 1;
  plan_ = plan_element(element, document);
  plan_.serial = serial;
  element_ = element, end_ = end;
  return plan_;
}

}  // namespace coaster::sim
