// The elements defined in plan: banked curve, helix, S-bend and overbanked turn.
#include <algorithm>
#include <cmath>
#include <functional>

#include "base/portable_math.h"
#include "sim/plan/element_arcs.h"
#include "sim/plan/element_shapes.h"
#include "world/motion.h"

namespace coaster::sim {
namespace {

using base::kPi;

constexpr double kMostHelixSlope = 0.6;    // m per m in plan
constexpr double kLongestHelix = 14'000;   // m, in plan, without the ramps
constexpr double kLeastRamp = 3;           // m
constexpr double kMostCurveRoll_deg = 30;  // per metre of a ramp

struct Slope {
  double rise, change;  // dy/du and its derivative
};

// Returns a point of a turn over the length u in plan. `heading`: rad, positive to the right, with its derivative
// `bend`.
ElementRate plan_rate(double heading, double bend, Slope slope, double roll) {
  const auto [sin, cos] = base::sin_cos(heading);
  return {{cos, slope.rise, -sin}, {-sin * bend, slope.change, -cos * bend}, glm::dvec3(0), roll};
}

// A turn in plan: ramp, circle, ramp, to one side.
struct Round {
  Bend bend;    // of the heading, positive to the right
  double bank;  // rad where the curvature is largest; proportional to the curvature elsewhere
  double roll(double u) const { return bank * bend.bend(u) * bend.radius; }
};

void add_round(ElementPath& path, const Round& round, const std::function<Slope(double)>& slope) {
  const double ramp = round.bend.ramp();
  path.add({ramp, round.bend.arc(), ramp},
           [&](double u) { return plan_rate(round.bend.angle(u), round.bend.bend(u), slope(u), round.roll(u)); });
}

double turn_side(const world::Element& element) { return element.right ? 1.0 : -1.0; }

// Returns the bank for a speed: gravity and the turn together press straight into the seat.
double bank_of(const world::Element& element) {
  const double radius = world::value_of(element, "radius"), speed = world::value_of(element, "speed");
  return speed > 0 ? base::arc_tangent(speed * speed / radius, world::kGravity)
                   : base::radians(world::value_of(element, "bank"));
}

Round round_of(const world::Element& element, double angle, double ramp = 0) {
  return {{0, turn_side(element) * angle, world::value_of(element, "radius"), ramp}, bank_of(element)};
}

void widen(ShapeTask& task, double angle) {
  const double least = Bend{0, angle, 1e-3}.radius;
  if (world::value_of(task.element, "radius") < least)
    give_way(task.element, "radius", least, "a turn of this angle would be too short", task.lines);
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
  const double angle = base::radians(world::value_of(task.element, "angle"));
  widen(task, angle);
  if (const double ramp = world::value_of(task.element, "ramp"); ramp > 0) {
    const double most = angle * world::value_of(task.element, "radius"),
                 least = std::min(
                     most, std::max(kLeastRamp, base::degrees(std::abs(bank_of(task.element))) / kMostCurveRoll_deg));
    if (ramp > most) give_way(task.element, "ramp", most, "the curve has no room for longer ones", task.lines);
    if (ramp < least) give_way(task.element, "ramp", least, "a shorter one would roll too fast", task.lines);
  }
  const auto [sin, cos] = base::sin_cos(task.slope);
  const double rise = sin / cos;
  add_round(task.path, round_of(task.element, angle, world::value_of(task.element, "ramp")), [rise](double) {
    return Slope{rise, 0};
  });
}

// Over the first ramp the slope changes smoothly (3v^2 - 2v^3, with derivative 0 at both ends) from the end's to the
// helix's, and over the last to 0, so the derivative of the slope is 0 at both ends of each.
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

void add_s_bend(ShapeTask& task) {
  const double angle = base::radians(world::value_of(task.element, "angle"));
  widen(task, angle);
  const SBend s(angle, world::value_of(task.element, "radius"));
  const double side = turn_side(task.element), bank = side * bank_of(task.element), rise = tangent_of(task.slope);
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
  const double angle = base::radians(world::value_of(task.element, "angle")), g = world::kGravity;
  widen(task, angle);
  const Round round = round_of(task.element, angle);
  const double side = turn_side(task.element), ramp = round.bend.ramp(), length = round.bend.length();
  if (const double most = std::min(kMostSlope * length * 25 * std::sqrt(5.0) / 192,
                                   kMostCrest * length * length / (24 * round.bend.radius));
      world::value_of(task.element, "height") > most)
    give_way(task.element, "height", most, "a turn of this radius and angle would be too steep", task.lines);
  const double height = world::value_of(task.element, "height"), least = std::sqrt(2 * kLeastRest * g * height);
  if (const double given = world::value_of(task.element, "speed"); given > 0 && given < least)
    give_way(task.element, "speed", least, "a slower train cannot pass the top", task.lines);
  const double speed = world::value_of(task.element, "speed"),
               bank = base::radians(world::value_of(task.element, "bank"));
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

}  // namespace coaster::sim
