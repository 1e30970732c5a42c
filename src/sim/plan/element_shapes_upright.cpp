// The elements in a vertical plane: climb, dive, hills whose crests are parabolas, and the brake run.
#include <cmath>

#include "base/portable_math.h"
#include "sim/plan/element_arcs.h"
#include "sim/plan/element_shapes.h"
#include "world/motion.h"

namespace coaster::sim {
namespace {

// A crest between two feet. A train with speed v at the foot has v^2 - 2 g h at the crest, h higher. A body thrown from
// there would follow the parabola of parameter p = (v^2 - 2 g h) / g, y = -x^2 / (2 p); on rails of that shape riders
// float.
struct Hill {
  double p = 0;  // m
  Foot foot;
  double edge = 0;  // m, half the parabola's width
};

// `least_rest`: least entry energy, relative to that of the crest.
Hill hill_of(ShapeTask& task, double least_rest = 1.15) {
  const double height = world::value_of(task.element, "height"), g = world::kGravity;
  const double least = std::sqrt(2 * least_rest * g * height);
  if (world::value_of(task.element, "speed") < least)
    give_way(task.element, "speed", least, "a slower train cannot pass the crest", task.lines);
  const double speed = world::value_of(task.element, "speed"), p = speed * speed / g - 2 * height,
               radius = world::value_of(task.element, "radius");
  const auto rise = [&](double angle) {
    const double tangent = tangent_of(angle);
    return Foot(angle, radius, p).rise() + 0.5 * p * tangent * tangent;
  };
  const double angle = root(base::radians(0.5), base::radians(78), [&](double a) { return rise(a) - height; });
  return {p, Foot(angle, radius, p), p * tangent_of(angle)};
}

// The valley between two equal hills: like both feet, without the clothoids at level track.
void add_valley(ElementPath& path, const Foot& foot) {
  const double arc = foot.radius * (foot.angle - foot.second_angle), half = arc + foot.second;  // m
  path.add({foot.second, 2 * arc, foot.second}, [&](double u) {
    const double off = std::abs(u - half), on_foot = foot.first + foot.arc + off - arc;
    const double angle = off < arc ? off / foot.radius : foot.angle_at(on_foot);
    return upright_rate(u < half ? -angle : angle, off < arc ? 1 / foot.radius : foot.bend(on_foot));
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

void add_camelback(ShapeTask& task) {
  const Hill hill = hill_of(task);
  add_foot_up(task.path, hill.foot);
  add_parabola(task.path, hill.p, hill.edge);
  add_foot_down(task.path, hill.foot);
}

void add_bunny_hops(ShapeTask& task) {
  const double hops = std::floor(world::value_of(task.element, "hops"));
  if (hops != world::value_of(task.element, "hops"))
    give_way(task.element, "hops", hops, "only whole hops can be placed", task.lines);
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
  add_parabola(task.path, hill.p, hill.edge, 1, 0, task.element.right ? 2 * base::kPi : -2 * base::kPi);
  add_foot_down(task.path, hill.foot);
}

void add_brake_run(ShapeTask& task) {
  const auto add = [&](std::string_view length, const world::Equipment& equipment) {
    task.path.add(world::value_of(task.element, length), [](double) { return upright_rate(0, 0); });
    task.equipped.push_back({task.path.curve().points.size() - 1, equipment});
  };
  world::Equipment brakes{world::EquipmentKind::brake};
  brakes.speed = static_cast<float>(world::value_of(task.element, "speed"));
  brakes.acceleration = static_cast<float>(world::value_of(task.element, "acceleration"));
  add("brakes", brakes);
  add("station", {world::EquipmentKind::station});
}

}  // namespace coaster::sim
