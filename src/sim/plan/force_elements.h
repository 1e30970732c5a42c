// The palette's elements made of forces: each is a program of few keys at the open end, for further editing.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include <glm/glm.hpp>

#include "base/portable_math.h"
#include "sim/plan/force_path.h"
#include "world/components.h"
#include "world/element.h"

namespace coaster::sim {

// --- The end of a force program, without spans and without checking clearance: for searches that try many programs.
// And a Newton search for a few unknowns

// The end of a walk. Angles accumulate from the horizon or from the start: a loop adds 2 pi to the pitch.
struct ForceWalkEnd {
  ForceState end;
  double pitch = 0;      // rad above the horizon, about the start's left
  double heading = 0;    // rad, to the left, about the vertical
  double shift = 0;      // m, to the left of the start's heading
  double off_plane = 0;  // of the direction, to the left of the start's heading: -1 to 1
  double bank = 0;       // of the left above the horizon: -1 to 1; positive where it is banked to the right
  double rise() const { return end.tangent.y; }  // of the direction above the horizon: -1 to 1
};

inline constexpr double kWalkStep = 0.35;  // m

// Adds the smallest turn from one angle to the next.
inline void follow_angle(double& sum, double& before, double now) {
  const double turn = now - before;
  sum += turn > base::kPi ? turn - 2 * base::kPi : turn < -base::kPi ? turn + 2 * base::kPi : turn;
  before = now;
}

// Follows the task's program to its end in steps of about a third of a metre; positions are within a centimetre of
// force_path's. Nothing if the train falls below the least speed (world::kSlowestForce), if no curvature gives the
// required g, or if the program exceeds the largest length.
inline std::optional<ForceWalkEnd> walk_force(const ForceTask& task) {
  if (!(task.program.length <= world::longest_of(task.program.over))) return std::nullopt;
  const ForceLaw law(task);
  ForceWalkEnd walk;
  ForceState& state = walk.end = law.start();
  const glm::dvec3 start = state.position, up(0, 1, 0), left = glm::normalize(glm::cross(up, state.tangent)),
                   ahead = glm::cross(left, up);
  const auto pitch = [&] { return base::arc_tangent(state.tangent.y, glm::dot(state.tangent, ahead)); };
  const auto heading = [&] { return base::arc_tangent(glm::dot(state.tangent, left), glm::dot(state.tangent, ahead)); };
  double last_pitch = pitch(), last_heading = heading();
  walk.pitch = last_pitch;
  const bool whole = follow_law(law, kWalkStep, 0, state, [&](double x, const ForceState& next) {
    state = next;
    follow_angle(walk.pitch, last_pitch, pitch()), follow_angle(walk.heading, last_heading, heading());
    return !law.too_slow(state) && !law.rates(x, state).folded;
  });
  if (!whole) return std::nullopt;
  walk.shift = glm::dot(state.position - start, left), walk.off_plane = glm::dot(state.tangent, left);
  walk.bank = glm::cross(state.up, state.tangent).y;
  return walk;
}

// Returns x with every component of f(x) within `tolerance` of 0, by Newton's method with differences of `step` and
// steps that are halved if they do not help; nothing if there is no such x nearby or f returns nothing.
template <int N, class Function>
std::optional<glm::vec<N, double>> newton(glm::vec<N, double> x, double step, double tolerance, const Function& f) {
  using Vector = glm::vec<N, double>;
  const auto size = [](const Vector& v) {
    double most = 0;
    for (int i = 0; i < N; ++i) most = std::max(most, std::abs(v[i]));
    return most;
  };
  std::optional<Vector> off = f(x);
  for (int tries = 0; off && tries < 20; ++tries) {
    if (size(*off) <= tolerance) return x;
    glm::mat<N, N, double> slopes(0);
    for (int i = 0; i < N; ++i) {
      Vector beside = x;
      beside[i] += step;
      const std::optional<Vector> there = f(beside);
      if (!there) return std::nullopt;
      slopes[i] = (*there - *off) / step;
    }
    if (!(std::abs(glm::determinant(slopes)) > 1e-14)) return std::nullopt;
    const Vector by = glm::inverse(slopes) * *off;
    double part = 1;
    std::optional<Vector> next;
    for (; part > 0.01; part /= 2)
      if (next = f(x - part * by); next && size(*next) < size(*off)) break;
    if (!next || !(size(*next) < size(*off))) return std::nullopt;
    x -= part * by, off = next;
  }
  return std::nullopt;
}

// --- Elements of forces

struct ForceElement {
  std::string refusal;             // why there is none; empty if there is one
  std::vector<std::string> lines;  // values that were reduced
  world::ForceProgram program;
  std::optional<world::Equipment> equipment;  // of the whole element
};

// Returns the program of a force element (world::is_of_forces) whose values are within their limits. `start` has the
// open end, the train, and in its program the speed; `behind`: m from the train's first car to its last. Keys are
// symmetric in time where possible. If the track must end level, or at an angle, trials of the whole program find the
// one or two durations that decide it. Takes some 10 ms; the same bits everywhere.
ForceElement force_element(const world::Element& element, const ForceTask& start, double behind);

}  // namespace coaster::sim
