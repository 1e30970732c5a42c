#include "sim/plan/element_plan.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "base/text.h"
#include "curve/continuity.h"
#include "curve/frames.h"
#include "sim/plan/element_plan_cache.h"
#include "sim/plan/force_elements.h"
#include "sim/plan/force_plan.h"
#include "world/element_rows.h"
#include "world/topology.h"

namespace coaster::sim {
namespace {

using glm::dvec3;

constexpr double kLongestElement = 20'000;  // m

bool within_world(const ElementCurve& curve) {
  const double most = world::kMaxCoordinate;
  for (const ElementPoint& p : curve.points)
    for (int axis = 0; axis < 3; ++axis)
      if (!(std::abs(p.position[axis]) <= most)) return false;
  return true;
}

// Returns the part of a curve between two of its points.
ElementCurve part_of(const ElementCurve& curve, std::size_t from, std::size_t to) {
  ElementCurve part;
  part.points.assign(curve.points.begin() + static_cast<std::ptrdiff_t>(from),
                     curve.points.begin() + static_cast<std::ptrdiff_t>(to + 1));
  for (ElementPoint& p : part.points) p.s -= curve.points[from].s;
  part.breaks.push_back(0);
  for (const std::size_t at : curve.breaks)
    if (at > from && at < to) part.breaks.push_back(at - from);
  part.breaks.push_back(to - from);
  return part;
}

// Fits each part separately, so that knots are where equipment begins and ends.
void fit_parts(std::span<const EquippedPart> equipped, ElementPlan& plan) {
  std::size_t from = 0;
  for (const EquippedPart& part : equipped) {
    ElementFit fit = fit_element(part_of(plan.ideal, from, part.to));
    plan.equipment.push_back({fit.knots.size() - 1, part.equipment});
    if (from == 0) {
      plan.fit = std::move(fit);
    } else {
      plan.fit.knots.back().out_length = fit.knots.front().out_length;
      plan.fit.knots.insert(plan.fit.knots.end(), fit.knots.begin() + 1, fit.knots.end());
      plan.fit.error = std::max(plan.fit.error, fit.error), plan.fit.jump = std::max(plan.fit.jump, fit.jump);
      plan.fit.roll_error = std::max(plan.fit.roll_error, fit.roll_error);
      plan.fit.within = plan.fit.within && fit.within;
    }
    from = part.to;
  }
}

// Plans a force element: the section of its keys.
void plan_forces(const ForceTask& start, double behind, ElementPlan& plan) {
  ForceElement element = force_element(plan.element, start, behind);
  plan.refusal = std::move(element.refusal);
  if (!plan.refusal.empty()) return;
  plan.lines.insert(plan.lines.end(), element.lines.begin(), element.lines.end());
  ForceTask task = start;
  task.program = plan.forces.emplace(std::move(element.program));
  task.equipment = element.equipment;
  ForcePlan section = plan_force(task);
  plan.refusal = section.refusal.empty() ? stop_text(section) : section.refusal;
  if (!plan.refusal.empty()) return;
  plan.ideal = std::move(section.path.curve), plan.fit = std::move(section.fit.spans);
  plan.length = section.length;
  if (element.equipment) plan.equipment = {{plan.spans(), *element.equipment}};
}

double lowest_of(const ElementCurve& curve) {
  double lowest = curve.points.front().position.y;
  for (const ElementPoint& p : curve.points) lowest = std::min(lowest, p.position.y);
  return lowest;
}

ForceTask train_at(const world::Document& document, const TrackEnd& end, std::optional<double> speed) {
  world::ForceProgram program;
  program.speed = speed.value_or(kAssumedSpeed);
  return force_task(document, end, program);
}

}  // namespace

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
    if (cut != value) lines.push_back(beyond_limit(p, value, cut) + ".");
    value = p.names.empty() ? cut : std::round(cut);
  }
}

std::optional<TrackEnd> open_end(const world::Document& document) {
  if (document.track.closed) return std::nullopt;
  if (document.track.knots.empty()) {
    // Riders who hang below the rails need room for their feet over the platform.
    constexpr double kFeet = 2.6;  // m
    TrackEnd first;
    first.position.y = Land(document.park).standing(first.position.x, first.position.z, first.position.y);
    if (base::row_of(document.kind).heartline < 0) first.position.y += kFeet;
    return first;
  }
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
  if (world::is_of_forces(element.kind)) {
    plan.refusal = "this element is made of forces: it is placed at the open end, as a force section";
    return plan;
  }
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
  if (shape.equipped.empty()) plan.fit = fit_element(plan.ideal);
  else fit_parts(shape.equipped, plan);
  plan.lowest = lowest_of(plan.ideal);
  return plan;
}

ElementPlan plan_element(const world::Element& element, const world::Document& document, std::optional<double> speed) {
  const std::optional<TrackEnd> end = open_end(document);
  const bool of_forces = world::is_of_forces(element.kind);
  if (end && !of_forces) return plan_element(element, *end);
  ElementPlan plan;
  plan.element = element;
  clamp_values(plan.element, plan.lines);
  if (!end) {
    plan.refusal = world::kClosedTrack;
    return plan;
  }
  const world::Train* const cart = document.entities.find<world::Train>(world::first_cart(document));
  plan_forces(train_at(document, *end, speed), cart ? cart->behind() : 0, plan);
  if (!plan.refusal.empty()) return plan;
  if (!speed) plan.lines.push_back(assumed_text());
  plan.lowest = lowest_of(plan.ideal);
  return plan;
}

double depth_of(const ElementPlan& plan, const Land& land) {
  double deepest = -std::numeric_limits<double>::infinity();
  for (const ElementPoint& p : plan.ideal.points) deepest = std::max(deepest, land.depth(p.position));
  return deepest;
}

std::string assumed_text() {
  return fmt::format("No train reaches the open end: planned for {} m/s.", base::to_text(kAssumedSpeed));
}

const ElementPlan& ElementCache::plan(const world::Element& element, const world::Document& document,
                                      std::optional<double> speed) {
  const std::optional<TrackEnd> end = open_end(document);
  std::optional<ForceTask> train;
  if (end && world::is_of_forces(element.kind)) train = train_at(document, *end, speed);
  if (element_ == element && end_ == end && train_ == train && speed_ == speed) return plan_;
  const std::uint64_t serial = plan_.serial + 1;
  plan_ = plan_element(element, document, speed);
  plan_.serial = serial;
  element_ = element, end_ = end, train_ = train, speed_ = speed;
  return plan_;
}

}  // namespace coaster::sim
