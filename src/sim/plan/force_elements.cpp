// The keys of the force elements: consecutive keys, and the walk to their end.
#include "sim/plan/force_elements.h"

#include <cmath>
#include <functional>
#include <iterator>
#include <utility>

#include <fmt/format.h>

#include "base/least_change_solver.h"
#include "base/portable_math.h"
#include "base/text.h"
#include "sim/plan/force_plan.h"
#include "sim/ride/train.h"
#include "world/element_rows.h"

namespace coaster::sim {
namespace {

using base::degrees, base::radians;
using world::ForceChannel;
using world::ForceKey;
using world::ForceProgram;

constexpr double kForceHold = 0.06;                            // s, shortest time for which a bend stays at its g
constexpr double kSecondsPerG = 0.12, kLeastForceRamp = 0.25;  // s, from one g to the next
constexpr double kForceAngle = 1e-5;                           // rad, tolerance of directions
constexpr double kRollTolerance = 0.1;  // g: with a smaller one, rails that wind about the riders need many knots
constexpr double kMostHold = 20;        // s
constexpr double kMostTilt = 0.1;       // vertical component of a direction, if an element needs a level or upright end

// The input of an element's program.
struct ForceElementInput {
  const world::Element& element;
  ForceTask task;    // its program is empty: 0 s long
  double behind;     // m
  double slope = 0;  // rad above the horizon
  double felt = 1;   // g, vertical, at the end
  glm::dvec3 left{0};

  double value(std::string_view name) const { return world::value_of(element, name); }
  std::optional<ForceWalkEnd> walk(const world::ForceProgram& program) const {
    ForceTask whole = task;
    whole.program = program;
    return walk_force(whole);
  }
};

ForceElement no_element(std::string why) { return {std::move(why), {}, {}, {}}; }
ForceElement made(world::ForceProgram program, std::vector<std::string> lines = {}) {
  return {{}, std::move(lines), std::move(program), {}};
}

// Writes the vertical keys one after the other; the program is as long as they are.
class VerticalKeys {
 public:
  VerticalKeys(world::ForceProgram& program, double first) : program_(program) { put(first); }
  VerticalKeys& ramp(double to) {
    program_.length += std::max(kLeastForceRamp, kSecondsPerG * std::abs(to - keys().back().value));
    return put(to);
  }
  VerticalKeys& hold(double seconds) {
    program_.length += seconds;
    return put(keys().back().value);
  }

 private:
  std::vector<world::ForceKey>& keys() { return program_.keys(world::ForceChannel::vertical); }
  VerticalKeys& put(double value) { return keys().push_back({program_.length, value}), *this; }
  world::ForceProgram& program_;
};

// A bend that turns farther with more strength: up to 1 its g rises from `least` to `most`, beyond that it lasts
// longer.
struct ForcePull {
  double least, most;
  double g(double strength) const { return least + std::min(strength, 1.0) * (most - least); }
  void add(VerticalKeys& keys, double strength) const {
    keys.ramp(g(strength)).hold(kForceHold + std::max(strength - 1, 0.0));
  }
};

using ForcePrograms = std::function<world::ForceProgram(double strength)>;
// Returns the strength with which a program ends at that pitch, rad; nothing if there is none.
std::optional<double> strength_for(const ForceElementInput& maker, double pitch, const ForcePrograms& program) {
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

// Rolls by `turns` to the element's side: a quarter of the time to the full rate, a quarter from it. Rails at a
// distance from the riders' path wind about it, and so need slightly more or less than one turn to be upright again.
void add_roll(const ForceElementInput& maker, ForceProgram& program, double from, double seconds, double turns) {
  const double rate = (maker.element.right ? 360 : -360) * turns / (0.75 * seconds), quarter = seconds / 4;
  program.keys(ForceChannel::roll) = {
      {from, 0}, {from + quarter, rate}, {from + 3 * quarter, rate}, {from + seconds, 0}};
}

// The fraction of a whole roll that is complete after a fraction of its time, and its derivative.
struct RollShare {
  double angle, rate;
};
RollShare share_of_roll(double time) {
  if (time > 0.5) {
    const RollShare before = share_of_roll(1 - time);
    return {1 - before.angle, before.rate};
  }
  const double x = std::min(4 * time, 1.0);
  return {((x * x * x - x * x * x * x / 2) / 4 + std::max(time - 0.25, 0.0)) / 0.75, smooth_step(x) / 0.75};
}

// A turn during the search for its unknowns.
struct ForceTurn {
  struct Unknowns {
    double hold = 0;            // s, time at full bank
    double lift = 0, tilt = 0;  // g and rad, additional during the roll-in
    double roll_out = 0;        // rad, additional to the roll-in
  };
  const ForceElementInput& maker;
  double g, side;      // side: 1 to the right, -1 to the left
  double roll;         // s, duration of the roll-in and of the roll-out
  double angle, bank;  // rad

  // Level during the roll: the g increases by as much as the bank takes away.
  ForceProgram program(const Unknowns& x) const {
    const double in = bank + x.tilt, out_rate = 2 * degrees(in + x.roll_out) * side / roll,
                 in_rate = 2 * degrees(in) * side / roll, scale = (g - 1) / (1 / base::sin_cos(bank).cos - 1),
                 out = roll + x.hold;
    ForceProgram program = maker.task.program;
    const auto key = [&](double at, int i, double direction, double more) {
      const double share = half_roll(i), rate = direction * half_rate(i) * bank / roll;
      const auto [sin, cos] = base::sin_cos(share * bank);
      program.keys(ForceChannel::vertical)
          .push_back({at, 1 + scale * (1 / cos - 1) + more, scale * sin / (cos * cos) * rate});
    };
    for (int i = 0; i <= kParts; ++i) key(roll * i / kParts, i, 1, i > 0 && i < kParts ? x.lift : 0);
    for (int i = 0; i <= kParts; ++i) key(out + roll * i / kParts, kParts - i, -1, 0);
    program.keys(ForceChannel::roll) = {{0, 0},   {roll / 2, in_rate},         {roll, 0},
                                        {out, 0}, {out + roll / 2, -out_rate}, {out + roll, 0}};
    program.length = out + roll;
    return program;
  }

 private:
  static constexpr int kParts = 4;
  // Returns the fraction of the bank after i parts of a roll whose rate rises and falls by smooth steps, and its
  // derivative.
  static double half_roll(int i) {
    if (2 * i > kParts) return 1 - half_roll(kParts - i);
    const double x = 2.0 * i / kParts;
    return x * x * x - x * x * x * x / 2;
  }
  static double half_rate(int i) { return 2 * smooth_step(2.0 * std::min(i, kParts - i) / kParts); }
};

// A loop during the search for its unknowns: the time at full g, lateral g to the side and back, and the roll that
// keeps it upright, in degrees per second.
struct ForceLoop {
  const ForceElementInput& maker;
  double g;

  ForceProgram program(double hold, double away, double back, double rate) const {
    ForceProgram program = maker.task.program;
    VerticalKeys(program, maker.felt).ramp(g).hold(hold).ramp(1);
    const double quarter = program.length / 4;
    program.keys(ForceChannel::lateral) = {
        {0, 0}, {quarter, away}, {2 * quarter, 0}, {3 * quarter, -back}, {4 * quarter, 0}};
    program.keys(ForceChannel::roll) = {{0, 0}, {2 * quarter, rate}, {4 * quarter, 0}};
    return program;
  }
};

ForceElement force_turn(const ForceElementInput& maker) {
  constexpr double kLevel = 0.1, kBankRate = 45, kShortestRoll = 0.8, kShortestHold = 0.1;
  if (std::abs(maker.slope) > kLevel)
    return no_element(
        fmt::format("the turn is level, and the track has a slope of {:.0f} degrees there: add a valley "
                    "or a hill that ends level first",
                    degrees(maker.slope)));
  const double g = maker.value("g"), angle = radians(maker.value("angle")), v = maker.task.program.speed;
  const double pull = std::sqrt(g * g - 1), bank = base::arc_tangent(pull, 1);
  const ForceTurn turn{maker, g,   maker.element.right ? 1.0 : -1.0, std::max(kShortestRoll, degrees(bank) / kBankRate),
                       angle, bank};
  // An error of the bank becomes one of the slope, and back, as sine and cosine of the angle turned. So lift and tilt
  // together level the end and bring it to the height of the start, except near whole turns, where they cannot do both.
  const auto off = [&](glm::dvec4 x) -> std::optional<glm::dvec4> {
    if (!(x[0] >= kShortestHold && bank + std::abs(x[2]) + std::abs(x[3]) < 1.55)) return std::nullopt;
    const auto end = maker.walk(turn.program({x[0], x[1], x[2], x[3]}));
    if (!end) return std::nullopt;
    return glm::dvec4(-turn.side * end->heading - angle, end->rise(), end->bank,
                      (end->end.position.y - maker.task.end.position.y) / 100);
  };
  const auto least = off({kShortestHold, 0, 0, 0});
  if (!least) return no_element(fmt::format("the train is too slow for a turn: it starts at {:.1f} m/s", v));
  if (least->x > 0)
    return no_element(
        fmt::format("the roll-in and roll-out alone turn {:.0f} degrees at {:.6g} g and this speed: ask "
                    "for a larger angle or less g",
                    std::ceil(degrees(angle + least->x)), g));
  const double guess = kShortestHold + std::max(-least->x * v / (world::kGravity * pull), 0.02);
  auto found = newton<4>({guess, 0, 0, 0}, 1e-3, kForceAngle, off);
  if (!found) {
    const base::SinCos turned = base::sin_cos(angle);
    const auto both = [&](glm::dvec3 x) { return glm::dvec4(x[0], x[1] * turned.cos, x[1] * turned.sin, x[2]); };
    const auto level = newton<3>({guess, 0, 0}, 1e-3, kForceAngle, [&](glm::dvec3 x) -> std::optional<glm::dvec3> {
      const auto there = off(both(x));
      return there ? std::optional(glm::dvec3(*there)) : std::nullopt;
    });
    if (level) found = both(*level);
  }
  if (!found) return no_element("no level turn was found: the train is too slow, or the angle too large");
  return made(turn.program({(*found)[0], (*found)[1], (*found)[2], (*found)[3]}));
}

// A straight path: riders feel only gravity, in the axes of their turning seats, and a small addition `more`, up and to
// the left of the path, that keeps the path straight while the rails wind about it.
ForceElement force_heartline(const ForceElementInput& maker) {
  constexpr int kKeys = 16;  // between them the cubics are within 0.002 g of sine and cosine
  const double seconds = maker.value("seconds"), whole = (maker.element.right ? 2 : -2) * base::kPi;
  const auto program_of = [&](double turns, glm::dvec2 more) {
    ForceProgram program = maker.task.program;
    program.length = seconds;
    add_roll(maker, program, 0, seconds, turns);
    const double up = base::sin_cos(maker.slope).cos + more.x, left = more.y;
    for (int i = 0; i <= kKeys; ++i) {
      const RollShare done = share_of_roll(static_cast<double>(i) / kKeys);
      const auto [sin, cos] = base::sin_cos(whole * done.angle);
      const double at = seconds * i / kKeys, rate = whole * done.rate / seconds;
      const double vertical = up * cos - left * sin, lateral = up * sin + left * cos;
      program.keys(ForceChannel::vertical).push_back({at, vertical, -lateral * rate});
      program.keys(ForceChannel::lateral).push_back({at, lateral, vertical * rate});
    }
    return program;
  };
  const double rise = maker.task.end.forward.y;
  const auto found = newton<3>({1, 0, 0}, 1e-3, kForceAngle, [&](glm::dvec3 x) -> std::optional<glm::dvec3> {
    const auto end = maker.walk(program_of(x[0], {x[1], x[2]}));
    return end ? std::optional(glm::dvec3(end->bank, end->rise() - rise, end->off_plane)) : std::nullopt;
  });
  if (!found) return no_element("the train is too slow for a roll about a straight path: roll faster");
  return made(program_of((*found)[0], {(*found)[1], (*found)[2]}));
}

ForceElement force_loop(const ForceElementInput& maker) {
  const ForceLoop loop{maker, maker.value("g")};
  const double pitch = maker.slope + 2 * base::kPi, side = maker.element.right ? -1 : 1;  // the shift is to the left
  const auto plane = strength_for(maker, pitch, [&](double hold) { return loop.program(hold + kForceHold, 0, 0, 0); });
  if (!plane)
    return no_element(fmt::format("the train is too slow for a loop at {:.6g} g: it starts at {:.1f} m/s", loop.g,
                                  maker.task.program.speed));
  const double hold = *plane + kForceHold, seconds = loop.program(hold, 0, 0, 0).length;
  const double shift = side * maker.value("shift"), push = 4 * shift / (seconds * seconds * world::kGravity);
  const auto off = [&](glm::dvec4 x) -> std::optional<glm::dvec4> {
    const auto end = maker.walk(loop.program(x[0], x[1], x[2], 100 * x[3]));
    if (!end) return std::nullopt;
    return glm::dvec4(end->pitch - pitch, end->off_plane, (end->shift - shift) / 100, end->bank);
  };
  const auto found = newton<4>({hold, push, push, 0}, 1e-3, kForceAngle, off);
  if (!found) return no_element("no loop with that shift was found: ask for less shift or more g");
  return made(loop.program((*found)[0], (*found)[1], (*found)[2], 100 * (*found)[3]));
}

// Returns why there is no float of that duration: either the train still rises in the middle of it with the least pull,
// or no pull is enough.
std::string why_no_float(const ForceElementInput& maker, const ForcePrograms& half) {
  const std::string seconds = base::to_text(maker.value("seconds"));
  const auto flattest = maker.walk(half(0));
  if (flattest && flattest->pitch > 0)
    return fmt::format("the track rises too steeply to float for only {} s: float longer, or start flatter", seconds);
  return fmt::format("the train is too slow to float for {} s: it starts at {:.1f} m/s", seconds,
                     maker.task.program.speed);
}

// Makes a pull, a float with a level or nearly level middle, and the pull again so that it ends level.
ForceElement hill(const ForceElementInput& maker, double crest, bool falls, bool rolls) {
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

ForceElement valley(const ForceElementInput& maker) {
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

ForceElement brakes(const ForceElementInput& maker) {
  const double speed = maker.task.program.speed, to = maker.value("speed"), brake = maker.value("acceleration");
  if (speed <= to)
    return no_element(fmt::format("the train is slower than {} m/s already: {:.1f} m/s", base::to_text(to), speed));
  ForceElement element;
  element.program = maker.task.program;
  element.program.over = world::ForceDomain::distance;
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

// In the order of world::force_elements().
constexpr ForceElement (*kForceElements[])(const ForceElementInput&) = {
    [](const ForceElementInput& maker) { return hill(maker, maker.value("g"), maker.value("ends") > 0, false); },
    valley,
    force_turn,
    [](const ForceElementInput& maker) { return hill(maker, 0, false, true); },
    force_heartline,
    force_loop,
    brakes};
static_assert(std::size(kForceElements) == world::force_elements().size());

}  // namespace

ForceElement force_element(const world::Element& element, const ForceTask& start, double behind) {
  const auto of_forces = static_cast<std::size_t>(element.kind) - world::elements().size();
  ForceElementInput maker{element, start, behind};
  maker.task.program = {};
  maker.task.program.over = world::ForceDomain::time, maker.task.program.speed = start.program.speed;
  const glm::dvec3 forward = start.end.forward, up = start.end.up;
  maker.left = glm::cross(up, forward);
  maker.slope = slope_of(forward);
  const ForceLaw law(maker.task);
  maker.felt = law.wanted(0).up.value;
  maker.task.program.length = 0;
  if (start.program.speed < world::kSlowestForce) return no_element(too_slow_text(start.program.speed));
  if (element.kind == world::ElementKind::force_brakes) return brakes(maker);
  if (std::abs(degrees(maker.slope)) > kSteepestEnd_deg)
    return no_element(fmt::format("the track is steeper than {} degrees there", base::to_text(kSteepestEnd_deg)));
  if (std::abs(maker.left.y) > kMostTilt || up.y < 0)
    return no_element("the track is banked there, and this element needs an upright start");
  return kForceElements[of_forces](maker);
}

}  // namespace coaster::sim
