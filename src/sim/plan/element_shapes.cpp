// The lead-in from the track's end to an element, and the shapes of the elements that stay upright.
#include "sim/plan/element_shapes.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>

#include <fmt/format.h>

#include "base/portable_math.h"
#include "base/text.h"
#include "world/element_rows.h"
#include "world/motion.h"

namespace coaster::sim {
namespace {

using base::kPi;
using glm::dvec3;

constexpr double kMostRollRate_deg = 60;  // per metre
constexpr double kLevel = 1e-4;           // rad: smaller slopes need no levelling
constexpr double kRollFade = 8;           // m, shortest length over which a rolled end is turned upright

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
    return ElementDerivatives{{cos, sin, 0},
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

void add_straight(ShapeTask& task, bool upright) {
  ElementPath& path = task.path;
  const double length = task.value("length"), most = kMostRollRate_deg * length;
  if (const double wanted = task.value("roll"); std::abs(wanted) > most)
    task.give_way("roll", wanted < 0 ? -most : most, "a straight this short cannot roll that far");
  const double roll = task.radians("roll");
  const dvec3 forward = path.end().tangent, level = upright ? curve::perpendicular(forward, {0, 1, 0}) : path.end().up;
  path.set_axes(forward, level, glm::cross(level, forward));
  path.add(length, [=](double u) {
    return ElementDerivatives{{1, 0, 0}, {0, 0, 0}, {0, 1, 0}, roll * smooth_step(u / length)};
  });
}

// In the order of world::elements(). A straight is added by element_shape() itself.
struct ElementShapeRow {
  void (*add)(ShapeTask& task);
  bool level;  // begins level: a sloping end is levelled first
};
constexpr ElementShapeRow kAdders[] = {
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

void ShapeTask::give_way(std::string_view parameter, double limit, std::string_view reason) {
  const std::span<const world::ElementParameter> parameters = base::row_of(element.kind).parameters;
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    if (parameters[i].name != parameter) continue;
    lines.push_back(fmt::format(
        "{}: {}.", beyond_limit(parameters[i], element.values[i], std::round(limit * 1000.0) / 1000.0), reason));
    element.values[i] = limit;
  }
}

double ShapeTask::at_least(std::string_view parameter, double limit, std::string_view reason) {
  if (value(parameter) < limit) give_way(parameter, limit, reason);
  return value(parameter);
}

double ShapeTask::at_most(std::string_view parameter, double limit, std::string_view reason) {
  if (value(parameter) > limit) give_way(parameter, limit, reason);
  return value(parameter);
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
  ShapeTask task{element, path, 0, lines, shape.equipped};
  if (straight) {
    path.begin_element();
    add_straight(task, upright);
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
  task.slope = head(path);
  const ElementShapeRow& adder = kAdders[static_cast<std::size_t>(element.kind)];
  if (adder.level && std::abs(task.slope) > kLevel) {
    path.add(Bend{task.slope, 0, levelling_radius(element)});
    task.slope = 0;
  }
  path.begin_element();
  adder.add(task);
  shape.curve = path.finish(kRollFade);
  keep_end_slopes(shape.curve);
  equip(element, shape);
  return shape;
}

namespace {

constexpr double kMostHelixSlope = 0.6;    // m per m in plan
constexpr double kLongestHelix = 14'000;   // m, in plan, without the ramps
constexpr double kLeastRamp = 3;           // m
constexpr double kMostCurveRoll_deg = 30;  // per metre of a ramp

struct Slope {
  double rise, change;  // dy/du and its derivative
};

// Returns a point of a turn over the length u in plan. `heading`: rad, positive to the right, with its derivative
// `bend`.
ElementDerivatives plan_rate(double heading, double bend, Slope slope, double roll) {
  const auto [sin, cos] = base::sin_cos(heading);
  return {{cos, slope.rise, -sin}, {-sin * bend, slope.change, -cos * bend}, glm::dvec3(0), roll};
}

// A turn in plan: ramp, circle, ramp, to one side.
struct BankedTurn {
  Bend bend;    // of the heading, positive to the right
  double bank;  // rad where the curvature is largest; proportional to the curvature elsewhere
  double roll(double u) const { return bank * bend.bend(u) * bend.radius; }
};

void add_round(ElementPath& path, const BankedTurn& round, const std::function<Slope(double)>& slope) {
  const double ramp = round.bend.ramp();
  path.add({ramp, round.bend.arc(), ramp},
           [&](double u) { return plan_rate(round.bend.angle(u), round.bend.bend(u), slope(u), round.roll(u)); });
}

// Returns the bank for a speed: gravity and the turn together press straight into the seat.
double bank_of(const ShapeTask& task) {
  const double speed = task.value("speed");
  return speed > 0 ? base::arc_tangent(speed * speed / task.value("radius"), world::kGravity) : task.radians("bank");
}

BankedTurn round_of(const ShapeTask& task, double angle, double ramp = 0) {
  return {{0, task.side() * angle, task.value("radius"), ramp}, bank_of(task)};
}

// Returns the radius of a turn by that angle.
double wide_enough(ShapeTask& task, double angle) {
  return task.at_least("radius", Bend{0, angle, 1e-3}.radius, "a turn of this angle would be too short");
}

// Two turns with one crossing of curvature between them. The second is the point reflection of the first about the
// middle, so the heading is symmetric about it.
class SBend {
 public:
  SBend(double angle, double radius) : first_{0, angle, radius} {
    // Over half the crossing the heading turns by 5/16 of its length, over the radius.
    crossing_ = 2 * first_.ramp();
    arc_ = first_.radius * (angle - first_.ramp_angle() * 2.25);
  }
  double ramp() const { return first_.ramp(); }
  double arc() const { return arc_; }
  double crossing() const { return crossing_; }
  double length() const { return 2 * (ramp() + arc_) + crossing_; }
  // Returns the curvature in units of 1/radius, positive in the first turn.
  double share(double u) const {
    const double middle = 0.5 * length(), off = std::abs(u - middle);
    const double size = off < 0.5 * crossing_ ? 2 * smooth_step(0.5 + off / crossing_) - 1
                                              : smooth_step(std::clamp((middle - off) / ramp(), 0.0, 1.0));
    return u < middle ? size : -size;
  }
  double bend(double u) const { return share(u) / first_.radius; }
  double heading(double u) const {
    const double from_end = std::min(u, length() - u);
    if (from_end < ramp() + arc_) return first_angle(from_end);
    const double v = (from_end - ramp() - arc_) / crossing_;
    return first_angle(ramp() + arc_) + crossing_ / first_.radius * v * (1 - v * v * (2 - v));
  }

 private:
  double first_angle(double u) const {
    if (u <= ramp()) return first_.angle(u);
    return first_.ramp_angle() + (u - ramp()) / first_.radius;
  }
  Bend first_;  // only its ramp is used
  double crossing_ = 0, arc_ = 0;
};

}  // namespace

void add_curve(ShapeTask& task) {
  const double angle = task.radians("angle"), most = angle * wide_enough(task, angle);
  if (task.value("ramp") > 0) {
    const double rolled = base::degrees(std::abs(bank_of(task))) / kMostCurveRoll_deg;
    task.at_most("ramp", most, "the curve has no room for longer ones");
    task.at_least("ramp", std::min(most, std::max(kLeastRamp, rolled)), "a shorter one would roll too fast");
  }
  const auto [sin, cos] = base::sin_cos(task.slope);
  const double rise = sin / cos;
  add_round(task.path, round_of(task, angle, task.value("ramp")), [rise](double) { return Slope{rise, 0}; });
}

// Over the first ramp the slope changes smoothly (3v^2 - 2v^3, with derivative 0 at both ends) from the end's to the
// helix's, and over the last to 0, so the derivative of the slope is 0 at both ends of each.
void add_helix(ShapeTask& task) {
  const double most = kLongestHelix / (2.0 * kPi * task.value("radius"));
  const double turns = task.at_most("turns", most, "a helix of this radius would be longer than 15 km");
  const BankedTurn round = round_of(task, 2.0 * kPi * turns);
  const double ramp = round.bend.ramp(), whole = round.bend.length(), room = whole - ramp;
  const auto [sin, cos] = base::sin_cos(task.slope);
  const double first = sin / cos;
  const auto slope_for = [&](double height) { return (height - 0.5 * ramp * first) / room; };
  double steady = slope_for(task.value("height"));
  if (std::abs(steady) > kMostHelixSlope) {
    steady = std::clamp(steady, -kMostHelixSlope, kMostHelixSlope);
    task.give_way("height", steady * room + 0.5 * ramp * first, "a helix of this radius would be too steep");
  }
  add_round(task.path, round, [=](double u) {
    const bool late = u > 0.5 * whole;
    const double v = std::clamp((late ? whole - u : u) / ramp, 0.0, 1.0);
    const double share = smooth_step(v), rate = 6.0 * v * (1.0 - v) / ramp;
    return late ? Slope{steady * share, -steady * rate}
                : Slope{first + (steady - first) * share, (steady - first) * rate};
  });
}

void add_s_bend(ShapeTask& task) {
  const double angle = task.radians("angle");
  const SBend s(angle, wide_enough(task, angle));
  const double side = task.side(), bank = side * bank_of(task), rise = tangent_of(task.slope);
  task.path.add({s.ramp(), s.arc(), s.crossing(), s.arc(), s.ramp()}, [&](double u) {
    return plan_rate(side * s.heading(u), side * s.bend(u), {rise, 0}, bank * s.share(u));
  });
}

// Its height is h 64 (v (1 - v))^3 over the fraction v of its length in plan: slope and its rate are 0 at both ends.
// The slope is largest where 5 v (1 - v) = 1: h / length times 192 / (25 sqrt(5)).
void add_overbanked_turn(ShapeTask& task) {
  constexpr double kLeastRest = 1.15;  // least entry energy, relative to that of the top
  constexpr double kMostSlope = 1;     // m per m in plan
  constexpr double kMostCrest = 1.5;   // curvature of the crest, 24 h / length^2, relative to that of the plan
  const double angle = task.radians("angle"), g = world::kGravity;
  wide_enough(task, angle);
  const BankedTurn round = round_of(task, angle);
  const double side = task.side(), ramp = round.bend.ramp(), length = round.bend.length();
  const double most = std::min(kMostSlope * length * 25 * std::sqrt(5.0) / 192,
                               kMostCrest * length * length / (24 * round.bend.radius));
  const double height = task.at_most("height", most, "a turn of this radius and angle would be too steep");
  if (task.value("speed") > 0)
    task.at_least("speed", std::sqrt(2 * kLeastRest * g * height), "a slower train cannot pass the top");
  const double speed = task.value("speed"), bank = task.radians("bank");
  task.path.add({ramp, round.bend.arc(), ramp}, [&](double u) {
    const double v = u / length, w = v * (1 - v), odd = 1 - 2 * v, bend = round.bend.bend(u);
    const Slope slope{192 * height * w * w * odd / length, 384 * height * w * (odd * odd - w) / (length * length)};
    double roll = side * bank * smooth_step(1 - std::abs(odd));
    if (speed > 0) {
      // Gravity and the path's acceleration across the track, to the right and upwards.
      const double square = 1 + slope.rise * slope.rise, root_of_square = std::sqrt(square),
                   energy = speed * speed - 128 * g * height * w * w * w;
      roll = base::arc_tangent(energy * bend / square, (g + energy * slope.change / square) / root_of_square);
    }
    return plan_rate(round.bend.angle(u), bend, slope, roll);
  });
}

namespace {

// A crest between two feet. A train with speed v at the foot has v^2 - 2 g h at the crest, h higher. A body thrown from
// there would follow the parabola of parameter p = (v^2 - 2 g h) / g, y = -x^2 / (2 p); on rails of that shape riders
// float.
struct Hill {
  double p = 0;  // m
  HillFoot foot;
  double edge = 0;  // m, half the parabola's width
};

// `least_rest`: least entry energy, relative to that of the crest.
Hill hill_of(ShapeTask& task, double least_rest = 1.15) {
  const double height = task.value("height"), g = world::kGravity;
  const double speed =
      task.at_least("speed", std::sqrt(2 * least_rest * g * height), "a slower train cannot pass the crest");
  const double p = speed * speed / g - 2 * height, radius = task.value("radius");
  const auto rise = [&](double angle) {
    const double tangent = tangent_of(angle);
    return HillFoot(angle, radius, p).rise() + 0.5 * p * tangent * tangent;
  };
  const double angle = root(base::radians(0.5), base::radians(78), [&](double a) { return rise(a) - height; });
  return {p, HillFoot(angle, radius, p), p * tangent_of(angle)};
}

// The valley between two equal hills: like both feet, without the clothoids at level track.
void add_valley(ElementPath& path, const HillFoot& foot) {
  const double arc = foot.radius * (foot.angle - foot.second_angle), half = arc + foot.second;  // m
  path.add({foot.second, 2 * arc, foot.second}, [&](double u) {
    const double off = std::abs(u - half), on_foot = foot.first + foot.arc + off - arc;
    const double angle = off < arc ? off / foot.radius : foot.angle_at(on_foot);
    return upright_rate(u < half ? -angle : angle, off < arc ? 1 / foot.radius : foot.bend(on_foot));
  });
}

}  // namespace

void add_climb_or_dive(ShapeTask& task) {
  const double side = task.element.kind == world::ElementKind::climb ? 1.0 : -1.0, radius = task.value("radius");
  const double steepest = task.radians("angle");
  const auto bends = [&](double angle) {
    const double to = side * angle;
    return side * (Bend{task.slope, to, radius}.run_and_rise().y + Bend{to, 0, radius}.run_and_rise().y);
  };
  double height = task.value("height"), angle = steepest;
  if (const double least = bends(0); height < least) {
    task.give_way("height", least, "a smaller one cannot level out");
    height = least, angle = 0;
  } else if (bends(steepest) > height) {
    angle = root(0, steepest, [&](double a) { return bends(a) - height; });
  }
  const double to = side * angle, sin = base::sin_cos(angle).sin, missing = height - bends(angle);
  task.path.add(Bend{task.slope, to, radius});
  if (angle > 0 && missing > 0) task.path.add(missing / sin, [to](double) { return upright_rate(to, 0); });
  task.path.add(Bend{to, 0, radius});
}

void add_camelback(ShapeTask& task) {
  const Hill hill = hill_of(task);
  add_foot_up(task.path, hill.foot);
  add_parabola(task.path, hill.p, hill.edge);
  add_foot_down(task.path, hill.foot);
}

void add_bunny_hops(ShapeTask& task) {
  const double hops = task.at_most("hops", std::floor(task.value("hops")), "only whole hops can be placed");
  const Hill hill = hill_of(task);
  add_foot_up(task.path, hill.foot);
  for (int hop = 1; hop <= static_cast<int>(hops); ++hop) {
    if (hop > 1) add_valley(task.path, hill.foot);
    add_parabola(task.path, hill.p, hill.edge);
  }
  add_foot_down(task.path, hill.foot);
}

// The faster the train on the crest, the longer the parabola on which it is rolled.
void add_zero_g_roll(ShapeTask& task) {
  const Hill hill = hill_of(task, 1.5);
  add_foot_up(task.path, hill.foot);
  add_parabola(task.path, hill.p, hill.edge, 1, 0, 2 * kPi * task.side());
  add_foot_down(task.path, hill.foot);
}

void add_brake_run(ShapeTask& task) {
  const auto add = [&](std::string_view length, const world::Equipment& equipment) {
    task.path.add(task.value(length), [](double) { return upright_rate(0, 0); });
    task.equipped.push_back({task.path.curve().points.size() - 1, equipment});
  };
  world::Equipment brakes{world::EquipmentKind::brake};
  brakes.speed = static_cast<float>(task.value("speed"));
  brakes.acceleration = static_cast<float>(task.value("acceleration"));
  add("brakes", brakes);
  add("station", {world::EquipmentKind::station});
}

}  // namespace coaster::sim
