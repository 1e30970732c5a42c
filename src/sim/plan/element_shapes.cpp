// The lead-in from the track's end to an element, the straight, and the functions of the other elements by row.
#include "sim/plan/element_shapes.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "base/portable_math.h"
#include "base/text.h"
#include "world/element_rows.h"

namespace coaster::sim {
namespace {

using base::kPi;
using glm::dvec3;

constexpr double kMostRollRate_deg = 60;  // per metre
constexpr double kLevel = 1e-4;           // rad: smaller slopes need no levelling
constexpr double kRollFade = 8;           // m, shortest length over which a rolled end is turned upright

// Returns the angle above the horizon, rad.
double slope_of(dvec3 forward) {
  return base::arc_tangent(forward.y, std::sqrt(forward.x * forward.x + forward.z * forward.z));
}

// Adds the decrease from the end's curvature to 0, linear in the length, in the plane of the bend. `upright`: up
// follows the horizon; else it is carried along.
void ease(ElementPath& path, bool upright) {
  const dvec3 bend = path.end().curvature, forward = path.end().tangent;
  const double k = glm::length(bend);
  if (k == 0) return;
  const double length = std::min(kLongestEase, 2.0 * kEaseAngle / k);
  const dvec3 towards = curve::perpendicular(forward, bend), carried = path.end().up;
  const dvec3 axis = glm::cross(forward, towards);
  path.set_axes(forward, towards, axis);
  const dvec3 carried_here(glm::dot(carried, forward), glm::dot(carried, towards), glm::dot(carried, axis));
  path.add(length, [=](double u) {
    const double angle = k * (u - u * u / (2.0 * length)), rate = k * (1.0 - u / length);
    const auto [sin, cos] = base::sin_cos(angle);
    return ElementRate{{cos, sin, 0},
                       {-sin * rate, cos * rate, 0},
                       upright ? dvec3(0) : curve::rotate(carried_here, {0, 0, 1}, angle),
                       0};
  });
}

// Sets the axes along the heading; returns the angle above the horizon.
double head(ElementPath& path) {
  const dvec3 forward = path.end().tangent, ahead = glm::normalize(dvec3(forward.x, 0, forward.z)), up(0, 1, 0);
  path.set_axes(ahead, up, glm::cross(up, ahead));
  return slope_of(forward);
}

void add_straight(world::Element& element, ElementPath& path, bool upright, std::vector<std::string>& lines) {
  const double most = kMostRollRate_deg * world::value_of(element, "length");
  if (const double wanted = world::value_of(element, "roll"); std::abs(wanted) > most)
    give_way(element, "roll", wanted < 0 ? -most : most, "a straight this short cannot roll that far", lines);
  const double length = world::value_of(element, "length"), roll = base::radians(world::value_of(element, "roll"));
  const dvec3 forward = path.end().tangent, level = upright ? curve::perpendicular(forward, {0, 1, 0}) : path.end().up;
  path.set_axes(forward, level, glm::cross(level, forward));
  path.add(length, [=](double u) {
    return ElementRate{{1, 0, 0}, {0, 0, 0}, {0, 1, 0}, roll * smooth_step(u / length)};
  });
}

// In the order of world::elements(). A straight is added by element_shape() itself.
struct Adder {
  void (*add)(ShapeTask& task);
  bool level;  // begins level: a sloping end is levelled first
};
constexpr Adder kAdders[] = {
    {nullptr, false},           {add_curve, false},          {add_helix, false},     {add_climb_or_dive, false},
    {add_climb_or_dive, false}, {add_camelback, true},       {add_loop, true},       {add_corkscrew, true},
    {add_s_bend, false},        {add_overbanked_turn, true}, {add_bunny_hops, true}, {add_zero_g_roll, true},
    {add_immelmann, true},      {add_dive_loop, true},       {add_cobra_roll, true}, {add_brake_run, true}};
static_assert(std::size(kAdders) == world::elements().size());

// Returns the radius in m of the bend that levels the track before an element: its smallest radius, if it has one, or
// else by its height.
double levelling_radius(const world::Element& element) {
  if (const std::optional<double> radius = world::found_value(element, "radius")) return *radius;
  const std::optional<double> height = world::found_value(element, "height");
  return height ? std::max(12.0, 1.2 * *height) : 25.0;
}

// Tightens the slope errors at both ends, as far as a fit can meet them, so that joints with other elements do not push
// riders.
void keep_end_slopes(ElementCurve& curve) {
  constexpr double kSlopeError = 0.004;  // rad/m^2: jolts of 0.2 g to the side and 0.3 g along the track at 20 m/s
  curve.points.front().slope_error = curve.points.back().slope_error = kSlopeError;
}

// Adds the equipment that the element's parameters select for all of it.
void equip(const world::Element& element, ElementShape& shape) {
  const auto choice = static_cast<int>(world::found_value(element, "equipment").value_or(0.0));
  if (choice == 0) return;
  world::Equipment equipment{static_cast<world::EquipmentKind>(choice - 1)};
  equipment.speed = static_cast<float>(world::value_of(element, "speed"));
  if (const std::optional<double> acceleration = world::found_value(element, "acceleration"))
    equipment.acceleration = static_cast<float>(*acceleration);
  shape.equipped.push_back({shape.curve.points.size() - 1, equipment});
}

}  // namespace

std::string beyond_limit(const world::ElementParameter& parameter, double value, double limit) {
  const std::string unit = fmt::format("{}{}", parameter.unit.empty() ? "" : " ", parameter.unit);
  return fmt::format("{} {} from {}{} to the limit of {}{}", limit < value ? "Reduced" : "Raised", parameter.name,
                     base::to_text(value), unit, base::to_text(limit), unit);
}

void give_way(world::Element& element, std::string_view parameter, double limit, std::string_view reason,
              std::vector<std::string>& lines) {
  const std::span<const world::ElementParameter> parameters = base::row_of(element.kind).parameters;
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    if (parameters[i].name != parameter) continue;
    lines.push_back(fmt::format(
        "{}: {}.", beyond_limit(parameters[i], element.values[i], std::round(limit * 1000.0) / 1000.0), reason));
    element.values[i] = limit;
  }
}

ElementShape element_shape(world::Element& element, const TrackEnd& end, std::vector<std::string>& lines) {
  ElementShape shape;
  if (const double k = glm::length(end.curvature); k > kSharpestEnd) {
    shape.refusal = fmt::format("the open end is too sharp for an element: its radius is {} m",
                                base::to_text(std::round(1000.0 / k) / 1000.0));
    return shape;
  }
  const auto steep = [](dvec3 forward) { return std::abs(slope_of(forward)) > base::radians(kSteepestEnd_deg); };
  ElementPath path(end.position, end.forward, glm::length(end.curvature) < kStraightEnd ? dvec3(0) : end.curvature,
                   end.up, end.spin);
  const bool straight = element.kind == world::ElementKind::straight;
  const bool upright = !straight || !steep(end.forward);
  ease(path, upright);
  if (straight) {
    path.begin_element();
    add_straight(element, path, upright, lines);
    shape.curve = path.finish(path.curve().length());
    keep_end_slopes(shape.curve);
    equip(element, shape);
    return shape;
  }
  if (steep(end.forward) || steep(path.end().tangent)) {
    shape.refusal = fmt::format("the open end is steeper than {} degrees: only a straight can follow it",
                                base::to_text(kSteepestEnd_deg));
    return shape;
  }
  double slope = head(path);
  const Adder& adder = kAdders[static_cast<std::size_t>(element.kind)];
  if (adder.level && std::abs(slope) > kLevel) {
    path.add(Bend{slope, 0, levelling_radius(element)});
    slope = 0;
  }
  path.begin_element();
  ShapeTask task{element, path, slope, lines, shape.equipped};
  adder.add(task);
  shape.curve = path.finish(kRollFade);
  keep_end_slopes(shape.curve);
  equip(element, shape);
  return shape;
}

}  // namespace coaster::sim
