#include "sim/plan/force_elements.h"

#include <cmath>

#include <fmt/format.h>

#include "base/least_change.h"
#include "base/portable_math.h"
#include "base/text.h"
#include "sim/plan/force_maker.h"
#include "sim/plan/force_plan.h"

namespace coaster::sim {
namespace {

using base::degrees, base::radians;
using world::ForceChannel;
using world::ForceProgram;

constexpr double kRollTolerance = 0.1;  // g: with a smaller one, rails that wind about the riders need many knots
constexpr double kMostHold = 20;        // s
constexpr double kMostTilt = 0.1;       // vertical component of a direction, if an element needs a level or upright end

// Returns why there is no float of that duration: either the train still rises in the middle of it with the least pull,
// or no pull is enough.
std::string why_no_float(const ForceMaker& maker, const ForcePrograms& half) {
  const std::string seconds = base::to_text(maker.value("seconds"));
  const auto flattest = maker.walk(half(0));
  if (flattest && flattest->pitch > 0)
    return fmt::format("the track rises too steeply to float for only {} s: float longer, or start flatter", seconds);
  return fmt::format("the train is too slow to float for {} s: it starts at {:.1f} m/s", seconds,
                     maker.task.program.speed);
}

// Makes a pull, a float with a level or nearly level middle, and the pull again so that it ends level.
ForceElement hill(const ForceMaker& maker, double crest, bool falls, bool rolls) {
  const double seconds = maker.value("seconds");
  const ForcePull pull{crest, maker.value("pull")};
  const auto rise = [&](double strength, double until, ForceProgram& program) {
    VerticalKeys keys(program, maker.felt);
    pull.add(keys, strength);
    keys.ramp(crest);
    return keys.hold(until);
  };
  const ForcePrograms half = [&](double strength) {
    ForceProgram program = maker.task.program;
    rise(strength, seconds / 2, program);
    return program;
  };
  const auto up = strength_for(maker, 0, half);
  if (!up) return no_element(why_no_float(maker, half));
  std::vector<std::string> lines;
  if (*up < 0.99)
    lines.push_back(fmt::format("Reduced pull from {:.1f} g to {:.1f} g at the start: the track rises there already.",
                                pull.most, pull.g(*up)));
  const auto whole = [&](double first, double second, double turns) {
    ForceProgram program = maker.task.program;
    VerticalKeys keys = rise(first, seconds, program);
    if (rolls) {
      program.tolerance = kRollTolerance;
      add_roll(maker, program, program.length - seconds, seconds, turns);
    }
    if (falls) return keys.ramp(second), program;
    pull.add(keys, second);
    return keys.ramp(1), program;
  };
  if (falls) {  // straight at its end: with the g that the slope there leaves
    double g = 1;
    for (int i = 0; i < 12; ++i)
      if (const auto there = maker.walk(whole(*up, g, 0))) g = base::sin_cos(there->pitch).cos;
    return made(whole(*up, g, 0), std::move(lines));
  }
  const auto down = strength_for(maker, 0, [&](double strength) { return whole(*up, strength, 0); });
  if (!down) return no_element("no bend with that pull makes the hill end level");
  // From a level start it returns to its height; else the middle of the float stays level.
  const bool returns = std::abs(maker.slope) < 1e-3;
  const auto off = [&](glm::dvec3 x) -> std::optional<glm::dvec3> {
    const auto end = maker.walk(whole(x[0], x[1], x[2]));
    if (!end) return std::nullopt;
    const double higher = (end->end.position.y - maker.task.end.position.y) / 100;
    return glm::dvec3(returns ? higher : x[0] - *up, end->rise(), rolls ? end->bank : x[2] - 1);
  };
  const auto found = newton<3>({*up, *down, 1}, 1e-3, kForceAngle, off);
  if (!found) return no_element("no such hill was found that ends level: float longer, or pull more");
  return made(whole((*found)[0], (*found)[1], (*found)[2]), std::move(lines));
}

ForceElement valley(const ForceMaker& maker) {
  const double to = radians(maker.value("slope")), straight = base::sin_cos(maker.slope).cos;
  const ForcePull pull{straight, maker.value("g")};
  const std::string g = fmt::format("{:.6g} g", pull.most);
  if (std::abs(to - maker.slope) < radians(0.1))
    return no_element(fmt::format("the track has the slope of {:.1f} degrees already", degrees(to)));
  if ((to > maker.slope) != (pull.most > straight))
    return no_element(fmt::format("{} bends the track {}, away from a slope of {:.6g} degrees", g,
                                  pull.most > straight ? "up" : "down", degrees(to)));
  const ForcePrograms whole = [&](double strength) {
    ForceProgram program = maker.task.program;
    VerticalKeys keys(program, maker.felt);
    pull.add(keys, strength);
    return keys.ramp(base::sin_cos(to).cos), program;
  };
  const auto strength = strength_for(maker, to, whole);
  if (!strength)
    return no_element(
        fmt::format("the train is too slow for that slope: it starts at {:.1f} m/s", maker.task.program.speed));
  std::vector<std::string> lines;
  if (*strength < 0.99)
    lines.push_back(fmt::format("Reduced vertical from {} to {:.1f} g: it turns little.", g, pull.g(*strength)));
  return made(whole(*strength), std::move(lines));
}

ForceElement brakes(const ForceMaker& maker) {
  const double speed = maker.task.program.speed, to = maker.value("speed"), brake = maker.value("acceleration");
  if (speed <= to)
    return no_element(fmt::format("the train is slower than {} m/s already: {:.1f} m/s", base::to_text(to), speed));
  ForceElement element;
  element.program = maker.task.program;
  element.program.over = world::ForceOver::distance;
  const double length = std::ceil((speed * speed - to * to) / (2 * brake) + maker.behind) + 2;
  if (length > world::kLongestForce_m)
    return no_element(fmt::format("the brakes would be {:.0f} m long, and the limit is {} m: ask for more deceleration",
                                  length, base::to_text(world::kLongestForce_m)));
  element.program.length = std::max(length, world::kShortestForce_m);
  element.program.keys(ForceChannel::vertical) = {{0, maker.task.end.up.y}};
  if (std::abs(maker.left.y) > 1e-4) element.program.keys(ForceChannel::lateral) = {{0, maker.left.y}};
  world::Equipment& equipment = element.equipment.emplace(world::Equipment{world::EquipmentKind::brake});
  equipment.speed = static_cast<float>(to), equipment.acceleration = static_cast<float>(brake);
  return element;
}

}  // namespace

std::optional<double> strength_for(const ForceMaker& maker, double pitch, const ForcePrograms& program) {
  base::Equation equation;
  equation.value = [&](const std::vector<double>& x) -> std::optional<double> {
    const auto there = maker.walk(program(x.front()));
    return there ? std::optional(there->pitch) : std::nullopt;
  };
  equation.unknowns = {{1, 0.02, 0, kMostHold}};
  equation.wanted = pitch, equation.tolerance = kForceAngle, equation.trials = 120;
  const base::Solution solution = base::solve_by_least_change(equation);
  return solution.end == base::SolutionEnd::met ? std::optional(solution.unknowns.front()) : std::nullopt;
}

void add_roll(const ForceMaker& maker, ForceProgram& program, double from, double seconds, double turns) {
  const double rate = (maker.element.right ? 360 : -360) * turns / (0.75 * seconds), quarter = seconds / 4;
  program.keys(ForceChannel::roll) = {
      {from, 0}, {from + quarter, rate}, {from + 3 * quarter, rate}, {from + seconds, 0}};
}

ForceElement force_element(const world::Element& element, const ForceTask& start, double behind) {
  using world::ElementKind;
  ForceMaker maker{element, start, behind};
  maker.task.program = {};
  maker.task.program.over = world::ForceOver::time, maker.task.program.speed = start.program.speed;
  const glm::dvec3 forward = start.end.forward, up = start.end.up;
  maker.left = glm::cross(up, forward);
  maker.slope = base::arc_tangent(forward.y, std::sqrt(forward.x * forward.x + forward.z * forward.z));
  const ForceLaw law(maker.task);
  maker.felt = law.wanted(0).up.value;
  maker.task.program.length = 0;
  if (start.program.speed < world::kSlowestForce) return no_element(too_slow_text(start.program.speed));
  if (element.kind == ElementKind::force_brakes) return brakes(maker);
  if (std::abs(degrees(maker.slope)) > kSteepestEnd_deg)
    return no_element(fmt::format("the track is steeper than {} degrees there", base::to_text(kSteepestEnd_deg)));
  if (std::abs(maker.left.y) > kMostTilt || up.y < 0)
    return no_element("the track is banked there, and this element needs an upright start");
  switch (element.kind) {
    case ElementKind::force_hill: return hill(maker, maker.value("g"), maker.value("ends") > 0, false);
    case ElementKind::force_roll: return hill(maker, 0, false, true);
    case ElementKind::force_valley: return valley(maker);
    case ElementKind::force_heartline: return force_heartline(maker);
    case ElementKind::force_turn: return force_turn(maker);
    default: return force_loop(maker);
  }
}

}  // namespace coaster::sim
