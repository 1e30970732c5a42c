// Turns, rolls and loops made of forces.
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "base/portable_math.h"
#include "base/text.h"
#include "sim/plan/force_maker.h"
#include "sim/ride/train.h"

namespace coaster::sim {
namespace {

using base::degrees, base::radians;
using world::ForceChannel;
using world::ForceKey;
using world::ForceProgram;

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
struct Turn {
  struct Unknowns {
    double hold = 0;            // s, time at full bank
    double lift = 0, tilt = 0;  // g and rad, additional during the roll-in
    double roll_out = 0;        // rad, additional to the roll-in
  };
  const ForceMaker& maker;
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
struct Loop {
  const ForceMaker& maker;
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

}  // namespace

ForceElement force_turn(const ForceMaker& maker) {
  constexpr double kLevel = 0.1, kBankRate = 45, kShortestRoll = 0.8, kShortestHold = 0.1;
  if (std::abs(maker.slope) > kLevel)
    return no_element(
        fmt::format("the turn is level, and the track has a slope of {:.0f} degrees there: add a valley "
                    "or a hill that ends level first",
                    degrees(maker.slope)));
  const double g = maker.value("g"), angle = radians(maker.value("angle")), v = maker.task.program.speed;
  const double pull = std::sqrt(g * g - 1), bank = base::arc_tangent(pull, 1);
  const Turn turn{maker, g,   maker.element.right ? 1.0 : -1.0, std::max(kShortestRoll, degrees(bank) / kBankRate),
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
ForceElement force_heartline(const ForceMaker& maker) {
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

ForceElement force_loop(const ForceMaker& maker) {
  const Loop loop{maker, maker.value("g")};
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

}  // namespace coaster::sim
