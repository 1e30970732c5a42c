// The vertical elements: climb, dive and camelback in a vertical plane, loop and corkscrew about an axis.
#include <algorithm>
#include <cmath>

#include "base/portable_math.h"
#include "sim/plan/element_shapes.h"
#include "world/motion.h"

namespace coaster::sim {
namespace {

using base::kPi;
using glm::dvec2;
using glm::dvec3;

constexpr int kBisections = 60;

// Returns the x in [low, high] at which f crosses 0 upwards, to machine accuracy.
double root(double low, double high, const std::function<double(double)>& f) {
  for (int i = 0; i < kBisections; ++i) {
    const double middle = 0.5 * (low + high);
    (f(middle) < 0 ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

// The foot of a camelback, by its steepest angle: a clothoid to 1/radius, a circle, and a clothoid through the
// inflection to the parabola's curvature -bend. The other foot is its mirror image.
struct Foot {
  double angle, radius, crest_bend;
  double first, second, arc;  // m: clothoids and circle
  double first_angle, second_angle;
  Foot(double steepest, double least_radius, double p)
      : angle(steepest), radius(Bend(0, steepest, least_radius).radius) {
    const double r = radius;
    const double cos = base::sin_cos(steepest).cos;
    crest_bend = cos * cos * cos / p;
    first_angle = std::min(angle / 3, kPi / 6);
    first = 2 * r * first_angle;
    // As fast as the first clothoid, unless it would turn back by more than a quarter of the angle after the
    // inflection.
    second = std::min(first * (1 + r * crest_bend), 0.5 * angle * (1 / r + crest_bend) / (crest_bend * crest_bend));
    second_angle = 0.5 * second * (1 / r - crest_bend);
    arc = r * (angle - first_angle - second_angle);
  }
  double length() const { return first + arc + second; }
  double bend(double u) const {
    if (u < first) return u / (first * radius);
    if (u < first + arc) return 1 / radius;
    return 1 / radius - (1 / radius + crest_bend) * (u - first - arc) / second;
  }
  double angle_at(double u) const {
    if (u < first) return u * u / (2 * first * radius);
    if (u < first + arc) return first_angle + (u - first) / radius;
    const double v = u - first - arc;
    return angle - second_angle + v / radius - (1 / radius + crest_bend) * v * v / (2 * second);
  }
  double rise() const {
    constexpr int kSteps = 16;
    double sum = 0;
    for (const auto& [begin, part] : {dvec2(0, first), dvec2(first, arc), dvec2(first + arc, second)})
      sum += integral(part, kSteps, [&, from = begin](double u) {
               return dvec2(0, base::sin_cos(angle_at(from + u)).sin);
             }).y;
    return sum;
  }
};

double tangent_of(double angle) {
  const auto [sin, cos] = base::sin_cos(angle);
  return sin / cos;
}

// A turn about a level axis: in the plane across the axis a teardrop of clothoid, circle, clothoid, one whole turn,
// while it advances along the axis at a constant rate. The tangent keeps its angle to the axis, and curvature and
// torsion keep their ratio (a generalised helix), so after a whole turn the frame is as at the start: upright and
// straight ahead. Up is the normal: only gravity pushes sideways.
class Winding {
 public:
  // `top`: rad of the turn that are a circle in the plane across the axis.
  Winding(double height, double top) : ramp_angle_(kPi - 0.5 * top) {
    const dvec2 half = direction(0, ramp()) + direction(ramp(), 0.5 * top);  // from the foot to the apex, of radius 1
    radius_ = height / half.y;
    width_ = 2 * radius_ * half.x;
    arc_ = radius_ * top;
  }
  double ramp() const { return 2 * radius_ * ramp_angle_; }
  double arc() const { return arc_; }
  double length() const { return 2 * ramp() + arc_; }  // m, in the plane across
  double width() const { return width_; }              // m, advance of the teardrop in that plane
  double turned(double u) const {
    if (u <= ramp()) return u * u / (2 * radius_ * ramp());
    if (u < ramp() + arc_) return ramp_angle_ + (u - ramp()) / radius_;
    const double left = length() - u;
    return 2 * kPi - left * left / (2 * radius_ * ramp());
  }
  double bend(double u) const { return std::clamp(std::min(u, length() - u) / ramp(), 0.0, 1.0) / radius_; }

 private:
  dvec2 direction(double begin, double length) const {
    constexpr int kSteps = 48;
    return integral(length, kSteps, [&](double along) {
      const double u = begin + along;
      const auto [sin, cos] = base::sin_cos(u <= ramp() ? u * u / (2 * ramp()) : ramp_angle_ + (u - ramp()));
      return dvec2(cos, sin);
    });
  }
  double ramp_angle_, radius_ = 1, width_ = 0, arc_ = 0;
};

void add_winding(ElementPath& path, const Winding& w, double sin_axis, double side) {
  const double cos_axis = std::sqrt(1 - sin_axis * sin_axis);
  const dvec3 axis(sin_axis, 0, side * cos_axis), across(cos_axis, 0, -side * sin_axis), up(0, 1, 0);
  path.add({w.ramp(), w.arc(), w.ramp()}, [&](double u) {
    const auto [sin, cos] = base::sin_cos(w.turned(u));
    const dvec3 normal = cos * up - sin * across;
    return ElementRate{(sin_axis / cos_axis) * axis + cos * across + sin * up, w.bend(u) * normal, normal, 0};
  });
}

}  // namespace

void add_climb_or_dive(ShapeTask& task) {
  const double side = task.element.kind == world::ElementKind::climb ? 1.0 : -1.0,
               radius = world::value_of(task.element, "radius");
  const double steepest = base::radians(world::value_of(task.element, "angle"));
  const auto bends = [&](double angle) {
    const double to = side * angle;
    return side * (Bend{task.slope, to, radius}.run_and_rise().y + Bend{to, 0, radius}.run_and_rise().y);
  };
  double height = world::value_of(task.element, "height"), angle = steepest;
  if (const double least = bends(0); height < least) {
    give_way(task.element, "height", least, "a smaller one cannot level out", task.lines);
    height = least, angle = 0;
  } else if (bends(steepest) > height) {
    angle = root(0, steepest, [&](double a) { return bends(a) - height; });
  }
  const double to = side * angle, sin = base::sin_cos(angle).sin, missing = height - bends(angle);
  task.path.add(Bend{task.slope, to, radius});
  if (angle > 0 && missing > 0) task.path.add(missing / sin, [to](double) { return upright_rate(to, 0); });
  task.path.add(Bend{to, 0, radius});
}

// A train of speed v at the foot has v^2 - 2 g h at the crest, h higher. A body thrown from there would follow the
// parabola of parameter p = (v^2 - 2 g h) / g, y = -x^2 / (2 p); on rails of that shape riders float.
void add_camelback(ShapeTask& task) {
  constexpr double kLeastRest = 1.15;  // least entry energy, relative to that of the crest
  const double height = world::value_of(task.element, "height"), g = world::kGravity;
  const double least = std::sqrt(2 * kLeastRest * g * height);
  if (world::value_of(task.element, "speed") < least)
    give_way(task.element, "speed", least, "a slower train cannot pass the crest", task.lines);
  const double speed = world::value_of(task.element, "speed"), p = speed * speed / g - 2 * height,
               radius = world::value_of(task.element, "radius");
  const auto rise = [&](double angle) {
    const double tangent = tangent_of(angle);
    return Foot(angle, radius, p).rise() + 0.5 * p * tangent * tangent;
  };
  const double angle = root(base::radians(0.5), base::radians(78), [&](double a) { return rise(a) - height; });
  const Foot foot(angle, radius, p);
  const double edge = p * tangent_of(angle), whole = foot.length();
  task.path.add({foot.first, foot.arc, foot.second},
                [&](double u) { return upright_rate(foot.angle_at(u), foot.bend(u)); });
  task.path.add(2 * edge, [=](double u) {
    const double slope = (edge - u) / p;
    return ElementRate{{1, slope, 0}, {0, -1 / p, 0}, {-slope, 1, 0}, 0};
  });
  const auto down = [&](double from) {
    return [&foot, from](double u) { return upright_rate(-foot.angle_at(from - u), foot.bend(from - u)); };
  };
  task.path.add(foot.second, down(whole));
  task.path.add(foot.arc, down(whole - foot.second));
  task.path.add(foot.first, down(whole - (foot.second + foot.arc)));
}

void add_loop(ShapeTask& task) {
  constexpr double kMostAxis = 0.5;  // sine: 30 degrees
  const Winding w(world::value_of(task.element, "height"), base::radians(world::value_of(task.element, "top")));
  // Along an axis at the angle a it advances length * tan(a), of which cos(a) is sideways; the teardrop takes width *
  // sin(a) back.
  const double room = w.length() - w.width();
  if (world::value_of(task.element, "shift") > kMostAxis * room)
    give_way(task.element, "shift", kMostAxis * room, "a loop of this height would tip over sideways", task.lines);
  add_winding(task.path, w, world::value_of(task.element, "shift") / room, task.element.right ? -1.0 : 1.0);
}

void add_corkscrew(ShapeTask& task) {
  const Winding w(world::value_of(task.element, "height"), base::radians(world::value_of(task.element, "top")));
  add_winding(task.path, w, base::sin_cos(base::radians(world::value_of(task.element, "angle"))).sin,
              task.element.right ? -1.0 : 1.0);
}

}  // namespace coaster::sim
