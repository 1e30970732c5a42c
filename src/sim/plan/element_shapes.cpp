// The lead-in from the track's end to an element, and the elements in plan: straight, curve, helix.
#include "sim/plan/element_shapes.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/portable_math.h"
#include "base/text.h"
#include "world/motion.h"

namespace coaster::sim {
namespace {

using base::kPi;
using glm::dvec3;
using world::ElementKind;

constexpr double kMostHelixSlope = 0.6;   // m per m in plan
constexpr double kLongestHelix = 14'000;  // m, in plan, without the ramps
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

// A turn in plan: ramp, circle, ramp, to one side. The slope dy/du is `slopes(u)` with its derivative.
struct Round {
  Bend bend;    // of the heading, positive to the right
  double bank;  // rad where the curvature is largest; proportional to the curvature elsewhere
  double roll(double u) const { return bank * bend.bend(u) * bend.radius; }
};
struct Slope {
  double rise, change;  // dy/du and its derivative
};

void add_round(ElementPath& path, const Round& round, const std::function<Slope(double)>& slope) {
  const double ramp = round.bend.ramp();
  path.add({ramp, round.bend.arc(), ramp}, [&](double u) {
    const auto [sin, cos] = base::sin_cos(round.bend.angle(u));
    const auto [rise, change] = slope(u);
    const double k = round.bend.bend(u);
    return ElementRate{{cos, rise, -sin}, {-sin * k, change, -cos * k}, dvec3(0), round.roll(u)};
  });
}

// The bank follows from a speed: gravity and the turn together press straight into the seat.
Round round_of(const world::Element& element, double angle) {
  const double side = element.right ? 1.0 : -1.0, radius = world::value_of(element, "radius"),
               speed = world::value_of(element, "speed");
  const double bank = speed > 0 ? base::arc_tangent(speed * speed / radius, world::kGravity)
                                : base::radians(world::value_of(element, "bank"));
  return {{0, side * angle, radius}, bank};
}

bool begins_level(ElementKind kind) {
  return kind == ElementKind::camelback || kind == ElementKind::loop || kind == ElementKind::corkscrew;
}

// Returns the radius in m of the bend that levels out before an element.
double levelling_radius(const world::Element& element) {
  return element.kind == ElementKind::camelback ? world::value_of(element, "radius")
                                                : std::max(12.0, 1.2 * world::value_of(element, "height"));
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

void add_curve(ShapeTask& task) {
  const double angle = base::radians(world::value_of(task.element, "angle")), least = Bend{0, angle, 1e-3}.radius;
  if (world::value_of(task.element, "radius") < least)
    give_way(task.element, "radius", least, "a curve of this angle would be too short", task.lines);
  const auto [sin, cos] = base::sin_cos(task.slope);
  const double rise = sin / cos;
  add_round(task.path, round_of(task.element, angle), [rise](double) { return Slope{rise, 0}; });
}

// Over the first ramp the slope changes smoothly (3v^2 - 2v^3, with derivative 0 at both ends) from the end's to
// the helix's, and over the last to 0; so the curvature of the slope is 0 at both ends.
void add_helix(ShapeTask& task) {
  const double most = kLongestHelix / (2.0 * kPi * world::value_of(task.element, "radius"));
  if (world::value_of(task.element, "turns") > most)
    give_way(task.element, "turns", most, "a helix of this radius would be longer than 15 km", task.lines);
  const double angle = 2.0 * kPi * world::value_of(task.element, "turns");
  const Round round = round_of(task.element, angle);
  const double ramp = round.bend.ramp(), whole = round.bend.length(), room = whole - ramp;
  const auto [sin, cos] = base::sin_cos(task.slope);
  const double first = sin / cos;
  const auto slope_for = [&](double height) { return (height - 0.5 * ramp * first) / room; };
  double steady = slope_for(world::value_of(task.element, "height"));
  if (std::abs(steady) > kMostHelixSlope) {
    steady = std::clamp(steady, -kMostHelixSlope, kMostHelixSlope);
    give_way(task.element, "height", steady * room + 0.5 * ramp * first, "a helix of this radius would be too steep",
             task.lines);
  }
  add_round(task.path, round, [=](double u) {
    const bool late = u > 0.5 * whole;
    const double v = std::clamp((late ? whole - u : u) / ramp, 0.0, 1.0);
    const double share = smooth_step(v), rate = 6.0 * v * (1.0 - v) / ramp;
    return late ? Slope{steady * share, -steady * rate}
                : Slope{first + (steady - first) * share, (steady - first) * rate};
  });
}

ElementShape element_shape(world::Element& element, const TrackEnd& end, std::vector<std::string>& lines) {
  ElementShape shape;
  if (const double k = glm::length(end.curvature); k > kSharpestEnd) {
    shape.refusal = fmt::format("the track's end is too sharp for an element: its radius is {} m",
                                base::to_text(std::round(1000.0 / k) / 1000.0));
    return shape;
  }
  const auto steep = [](dvec3 forward) { return std::abs(slope_of(forward)) > base::radians(kSteepestEnd_deg); };
  ElementPath path(end.position, end.forward, glm::length(end.curvature) < kStraightEnd ? dvec3(0) : end.curvature,
                   end.up, end.spin);
  const bool straight = element.kind == ElementKind::straight;
  const bool upright = !straight || !steep(end.forward);
  ease(path, upright);
  if (straight) {
    path.begin_element();
    add_straight(element, path, upright, lines);
    shape.curve = path.finish(path.curve().length());
    return shape;
  }
  if (steep(end.forward) || steep(path.end().tangent)) {
    shape.refusal = fmt::format("the track's end is steeper than {} degrees: only a straight can follow it",
                                base::to_text(kSteepestEnd_deg));
    return shape;
  }
  double slope = head(path);
  if (begins_level(element.kind) && std::abs(slope) > kLevel) {
    path.add(Bend{slope, 0, levelling_radius(element)});
    slope = 0;
  }
  path.begin_element();
  ShapeTask task{element, path, slope, lines};
  switch (element.kind) {
    case ElementKind::straight: break;
    case ElementKind::curve: add_curve(task); break;
    case ElementKind::helix: add_helix(task); break;
    case ElementKind::climb:
    case ElementKind::dive: add_climb_or_dive(task); break;
    case ElementKind::camelback: add_camelback(task); break;
    case ElementKind::loop: add_loop(task); break;
    case ElementKind::corkscrew: add_corkscrew(task); break;
  }
  shape.curve = path.finish(kRollFade);
  return shape;
}

}  // namespace coaster::sim
