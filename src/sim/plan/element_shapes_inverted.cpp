// The elements that turn riders upside down about a level axis: loop, corkscrew, Immelmann, dive loop and cobra roll.
#include <algorithm>
#include <cmath>

#include "base/portable_math.h"
#include "sim/plan/element_path.h"
#include "sim/plan/element_shapes.h"
#include "world/motion.h"

namespace coaster::sim {
namespace {

using base::kPi;
using glm::dvec2;
using glm::dvec3;

void add_winding(ElementPath& path, const Winding& w, double sin_axis, double side) {
  const double cos_axis = std::sqrt(1 - sin_axis * sin_axis);
  const dvec3 axis(sin_axis, 0, side * cos_axis), across(cos_axis, 0, -side * sin_axis), up(0, 1, 0);
  path.add({w.ramp(), w.arc(), w.ramp()}, [&](double u) {
    const auto [sin, cos] = base::sin_cos(w.turned(u));
    const dvec3 normal = cos * up - sin * across;
    return ElementDerivatives{(sin_axis / cos_axis) * axis + cos * across + sin * up, w.bend(u) * normal, normal, 0};
  });
}

// A loop from its level foot to the point after its top where a parabola continues it: a clothoid to 1/radius over
// three quarters of the angle, and another to the parabola's curvature.
struct HalfLoop {
  double radius, end_bend, first_angle, first, second;
  HalfLoop(double angle, double smallest_radius, double end)
      : radius(smallest_radius),
        end_bend(end),
        first_angle(0.75 * angle),
        first(2 * radius * first_angle),
        second(2 * (angle - first_angle) / (1 / radius + end_bend)) {}
  double length() const { return first + second; }
  double angle_at(double u) const {
    if (u < first) return u * u / (2 * first * radius);
    const double v = u - first;
    return first_angle + v / radius - (1 / radius - end_bend) * v * v / (2 * second);
  }
  double bend(double u) const {
    return u < first ? u / (first * radius) : 1 / radius - (1 / radius - end_bend) * (u - first) / second;
  }
  double rise() const {
    constexpr int kSteps = 48;
    const auto part = [&](double begin, double part_length) {
      return integral(part_length, kSteps, [&](double u) { return dvec2(0, base::sin_cos(angle_at(begin + u)).sin); })
          .y;
    };
    return part(0, first) + part(first, second);
  }
};

// Half a loop and half a roll, upwards (Immelmann) or downwards (dive loop). Riders are rolled over on a parabola on
// which they float, as on a camelback's.
struct RolledLoop {
  double p;  // m, of the parabola
  HillFoot foot;
  double edge;  // m, half the parabola's width
  HalfLoop loop;
};

// `below`: m, distance from the element's upper end down to the height at which the train has the element's speed.
RolledLoop rolled_loop(ShapeTask& task, double below) {
  const double height = task.value("height"), radius = task.value("radius"), angle = task.radians("angle"),
               g = world::kGravity;
  const double tangent = tangent_of(angle), cos = base::sin_cos(angle).cos;
  const auto crest = [&](double p) { return HillFoot(angle, radius, p).rise() + 0.5 * p * tangent * tangent; };
  const double least_p = std::max(4.0, 0.2 * height), least = std::sqrt(g * (least_p + 2 * (below + crest(least_p))));
  const double speed = task.at_least("speed", least, "a slower train cannot pass the crest"),
               energy = speed * speed / g;
  const double p = root(0.5 * least_p, energy, [&](double x) { return x + 2 * (below + crest(x)) - energy; });
  const HillFoot foot(angle, radius, p);
  const double bend = cos * cos * cos / p, loop_rise = height + foot.rise();
  const double smallest =
      root(0.01 * loop_rise, loop_rise, [&](double r) { return HalfLoop(kPi - angle, r, bend).rise() - loop_rise; });
  return {p, foot, p * tangent, HalfLoop(kPi - angle, smallest, bend)};
}

// Half of a cobra roll, in the axes forward, up, and the side to which it exits: a loop whose plane turns about the
// vertical by 90 degrees from shortly before its top on, so that it ends perpendicular to the entry, in a valley.
class HalfCobra {
 public:
  HalfCobra(double height, double top) : up_(height, top), second_(up_.ramp() / (1 + kValley)) {}
  double ramp() const { return up_.ramp(); }
  double arc() const { return up_.arc(); }
  double second() const { return second_; }
  double length() const { return ramp() + arc() + second_; }
  ElementDerivatives at(double u) const {
    const double rest = u - ramp() - arc(), r = up_.radius();
    const double angle = rest < 0
                             ? up_.turned(u)
                             : up_.turned(ramp() + arc()) + rest / r - (1 - kValley) * rest * rest / (2 * r * second_);
    const double bend = rest < 0 ? up_.bend(u) : (1 - (1 - kValley) * rest / second_) / r;
    // The turn of the plane is C2 in the angle, so the roll rate is continuous.
    const double v = std::clamp((angle - kFrom) / (kTo - kFrom), 0.0, 1.0), w = v * (1 - v);
    const double plane = 0.5 * kPi * v * v * v * (10 - 15 * v + 6 * v * v), rate = 15 * kPi * w * w / (kTo - kFrom);
    const auto [sin, cos] = base::sin_cos(angle);
    const auto [plane_sin, plane_cos] = base::sin_cos(plane);
    const dvec3 normal(-sin * plane_cos, cos, -sin * plane_sin), across(-plane_sin, 0, plane_cos);
    const dvec3 towards =
        normal + rate * cos * across;  // towards the centre of the bend: the only lateral force is gravity
    return {{cos * plane_cos, sin, cos * plane_sin}, bend * towards, towards, 0};
  }

 private:
  static constexpr double kValley = 0.3;                           // curvature of the valley, relative to the top's
  static constexpr double kFrom = 5.0 / 6.0 * kPi, kTo = 2 * kPi;  // rad of the loop over which its plane turns
  Winding up_;
  double second_;
};

}  // namespace

void add_loop(ShapeTask& task) {
  constexpr double kMostAxis = 0.5;  // sine: 30 degrees
  const Winding w(task.value("height"), task.radians("top"));
  // Along an axis at the angle a it advances length * tan(a), of which cos(a) is sideways; the teardrop takes width *
  // sin(a) back.
  const double room = w.length() - w.width();
  const double shift = task.at_most("shift", kMostAxis * room, "a loop of this height would tip over sideways");
  add_winding(task.path, w, shift / room, -task.side());
}

void add_corkscrew(ShapeTask& task) {
  const Winding w(task.value("height"), task.radians("top"));
  add_winding(task.path, w, base::sin_cos(task.radians("angle")).sin, -task.side());
}

void add_immelmann(ShapeTask& task) {
  const RolledLoop shape = rolled_loop(task, task.value("height"));
  const HalfLoop& loop = shape.loop;
  task.path.add({loop.first, loop.second}, [&](double u) { return upright_rate(loop.angle_at(u), loop.bend(u)); });
  add_parabola(task.path, shape.p, shape.edge, -1, kPi * task.side(), 2 * kPi * task.side());
  add_foot_down(task.path, shape.foot, -1);
}

void add_dive_loop(ShapeTask& task) {
  const RolledLoop shape = rolled_loop(task, 0);
  const HalfLoop& loop = shape.loop;
  add_foot_up(task.path, shape.foot);
  add_parabola(task.path, shape.p, shape.edge, 1, 0, kPi * task.side());
  task.path.add({loop.second, loop.first}, [&](double u) {
    const double left = loop.length() - u;
    ElementDerivatives rate = upright_rate(loop.angle_at(left), loop.bend(left));
    rate.d1 = -rate.d1;
    return rate;
  });
}

// The second half is the mirror image of the first one, ridden backwards.
void add_cobra_roll(ShapeTask& task) {
  const HalfCobra half(task.value("height"), task.radians("top"));
  const dvec3 side(1, 1, -task.side()), mirror(1, 1, -1);
  task.path.add({half.ramp(), half.arc(), half.second()}, [&](double u) {
    const ElementDerivatives rate = half.at(u);
    return ElementDerivatives{side * rate.d1, side * rate.d2, side * rate.up, 0};
  });
  task.path.add({half.second(), half.arc(), half.ramp()}, [&](double u) {
    const ElementDerivatives rate = half.at(half.length() - u);
    return ElementDerivatives{-mirror * side * rate.d1, mirror * side * rate.d2, mirror * side * rate.up, 0};
  });
}

}  // namespace coaster::sim
