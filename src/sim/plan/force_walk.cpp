#include "sim/plan/force_walk.h"

#include "base/portable_math.h"

namespace coaster::sim {
namespace {

using glm::dvec3;

constexpr double kWalkStep = 0.35;  // m

// Adds the least turn from one angle to the next.
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
  double last_pitch = pitch(), last_heading = heading(), x = 0;
  walk.pitch = last_pitch;
  for (const double until : law.breaks()) {
    while (x < until) {
      const double rest = until - x, wish = kWalkStep / law.metres_per_unit(state);
      const double step = rest <= wish ? rest : rest < 2 * wish ? rest / 2 : wish;
      state = law.step(x, state, step), x = step == rest ? until : x + step;
      if (!(state.square >= world::kSlowestForce * world::kSlowestForce) || law.rates(x, state).folded)
        return std::nullopt;
      follow_angle(walk.pitch, last_pitch, pitch()), follow_angle(walk.heading, last_heading, heading());
    }
  }
  walk.shift = glm::dot(state.position - start, left), walk.off_plane = glm::dot(state.tangent, left);
  walk.bank = glm::cross(state.up, state.tangent).y;
  return walk;
}

}  // namespace coaster::sim
