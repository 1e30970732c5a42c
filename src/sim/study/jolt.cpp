#include "sim/study/jolt.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "sim/study/envelope.h"

namespace coaster::sim {
namespace {

constexpr int kEntriesPerCutoff = 50;  // entries per 1 / cutoff

// Responses of the low-pass of 1 Hz to a unit impulse and a unit step. Afterwards both stay closer to their final
// values than before.
struct Responses {
  std::array<float, kEntriesPerCutoff * 3 / 2> impulse{}, step{};
};

const Responses& responses() {
  static const Responses kResponses = [] {
    Responses r;
    r.impulse[1] = kEntriesPerCutoff;
    std::fill(r.step.begin() + 1, r.step.end(), 1.0f);
    low_pass(r.impulse, kEntriesPerCutoff, 1);
    low_pass(r.step, kEntriesPerCutoff, 1);
    return r;
  }();
  return kResponses;
}

glm::vec3 vector_of(const Force& force) { return {force.forward, force.left, force.up}; }

// Updates `found` with the larger of each value.
void take(const Jolt& one, Jolt& found) {
  found.forward = std::max(found.forward, one.forward);
  found.left = std::max(found.left, one.left);
  found.up = std::max(found.up, one.up);
  if (one.total > found.total) found.total = one.total, found.car = one.car, found.speed = one.speed;
}

}  // namespace

Jolt jolt_of(const Passage& passage, double cutoff) {
  const Responses& r = responses();
  const glm::vec3 impulse = static_cast<float>(cutoff) * vector_of(passage.impulse), step = vector_of(passage.step);
  glm::vec3 most(0);
  float square = 0;
  for (std::size_t i = 0; i < r.impulse.size(); ++i) {
    const glm::vec3 felt = r.impulse[i] * impulse + r.step[i] * step;
    most = glm::max(most, glm::abs(felt));
    square = std::max(square, glm::dot(felt, felt));
  }
  return {most.x, most.y, most.z, std::sqrt(square), passage.car, passage.speed};
}

std::vector<Jolt> jolts(const Ghost& ghost, std::size_t knots, double cutoff) {
  std::vector<Jolt> found(knots);
  for (const Passage& passage : ghost.passages) take(jolt_of(passage, cutoff), found.at(passage.knot));
  return found;
}

}  // namespace coaster::sim
