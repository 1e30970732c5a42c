#include "sim/plan/force_walk.h"

#include "base/portable_math.h"

namespace coaster::sim {
namespace {

using glm::dvec3;

constexpr double kWalkStep = 0.35;  // m

// Adds the smallest turn from one angle to the next.
void follow_angle(double& sum, double& before, double now) {
  const double turn = now - before;
  sum += turn > base::kPi ? turn - 2 * base::kPi : turn < -base::kPi ? turn + 2 * base::kPi : turn;
  before = now;
}

}  // namespace

std::optional<ForceWalk> walk_force(const ForceTask& task) {
  if (!(task.program.length <= world::longest_of(task.program.over))) return std::nullopt;
  const ForceLaw law(task);
  ForceWalk walk;
  ForceState& state = walk.end = law.start();
  const dvec3 start = state.position, up(0, 1, 0), left = glm::normalize(glm::cross(up, state.tangent)),
              ahead = glm::cross(left, up);
  const auto pitch = [&] { return base::arc_tangent(state.tangent.y, glm::dot(state.tangent, ahead)); };
  const auto heading = [&] { return base::arc_tangent(glm::dot(state.tangent, left), glm::dot(state.tangent, ahead)); };
  double last_pitch = pitch(), last_heading = heading();
  walk.pitch = last_pitch;
  const bool whole = follow_law(law, kWalkStep, 0, state, [&](double x, const ForceState& next) {
    state = next;
    follow_angle(walk.pitch, last_pitch, pitch()), follow_angle(walk.heading, last_heading, heading());
    return state.square >= world::kSlowestForce * world::kSlowestForce && !law.rates(x, state).folded;
  });
  if (!whole) return std::nullopt;
  walk.shift = glm::dot(state.position - start, left), walk.off_plane = glm::dot(state.tangent, left);
  walk.bank = glm::cross(state.up, state.tangent).y;
  return walk;
}

}  // namespace coaster::sim
