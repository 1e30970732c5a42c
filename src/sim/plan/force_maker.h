// Parts of the force elements: consecutive keys, and the walk to their end. Private to force_elements.cpp and
// force_turns.cpp.
#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "sim/plan/force_elements.h"
#include "sim/plan/force_walk.h"

namespace coaster::sim {

inline constexpr double kForceHold = 0.06;  // s, shortest time for which a bend stays at its g
inline constexpr double kSecondsPerG = 0.12, kLeastForceRamp = 0.25;  // s, from one g to the next
inline constexpr double kForceAngle = 1e-5;                           // rad, tolerance of directions

// The input of an element's program.
struct ForceMaker {
  const world::Element& element;
  ForceTask task;    // its program is empty: 0 s long
  double behind;     // m
  double slope = 0;  // rad above the horizon
  double felt = 1;   // g, vertical, at the end
  glm::dvec3 left{0};

  double value(std::string_view name) const { return world::value_of(element, name); }
  std::optional<ForceWalk> walk(const world::ForceProgram& program) const {
    ForceTask whole = task;
    whole.program = program;
    return walk_force(whole);
  }
};

inline ForceElement no_element(std::string why) { return {std::move(why), {}, {}, {}}; }
inline ForceElement made(world::ForceProgram program, std::vector<std::string> lines = {}) {
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
std::optional<double> strength_for(const ForceMaker& maker, double pitch, const ForcePrograms& program);

// Rolls by `turns` to the element's side: a quarter of the time to the full rate, a quarter from it. Rails at a
// distance from the riders' path wind about it, and so need slightly more or less than one turn to be upright again.
void add_roll(const ForceMaker& maker, world::ForceProgram& program, double from, double seconds, double turns);

// In force_turns.cpp.
ForceElement force_turn(const ForceMaker& maker);
ForceElement force_heartline(const ForceMaker& maker);
ForceElement force_loop(const ForceMaker& maker);

}  // namespace coaster::sim
