#include "sim/study/jolt.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "curve/continuity.h"
#include "sim/study/force_limits.h"
#include "sim/study/track_errata.h"

namespace coaster::sim {
namespace {

constexpr int kEntriesPerCutoff = 50;  // entries per 1 / cutoff
constexpr float kLeastStep = 0.05f;    // g: smaller ones do not count together

// Responses of the low-pass of 1 Hz to a unit impulse and a unit step. Afterwards both stay closer to their final
// values than before.
struct LowPassResponses {
  static constexpr std::size_t kCount = kEntriesPerCutoff * 3 / 2;
  std::array<float, kCount> impulse{}, step{}, ramp{};  // ramp: integral of the step's

  // Return one at a place between entries.
  float impulse_at(float x) const { return between(impulse, x); }
  float step_at(float x) const { return x < kCount - 1 ? between(step, x) : 1; }
  float ramp_at(float x) const {
    return x < kCount - 1 ? between(ramp, x) : ramp.back() + (x - static_cast<float>(kCount - 1)) / kEntriesPerCutoff;
  }

 private:
  static float between(const std::array<float, kCount>& values, float x) {
    if (!(x > 0) || x >= kCount - 1) return 0;
    const auto i = static_cast<std::size_t>(x);
    return std::lerp(values[i], values[i + 1], x - static_cast<float>(i));
  }
};

const LowPassResponses& responses() {
  static const LowPassResponses kResponses = [] {
    LowPassResponses r;
    r.impulse[1] = kEntriesPerCutoff;
    std::fill(r.step.begin() + 1, r.step.end(), 1.0f);
    low_pass(r.impulse, kEntriesPerCutoff, 1);
    low_pass(r.step, kEntriesPerCutoff, 1);
    for (std::size_t i = 1; i < r.ramp.size(); ++i)
      r.ramp[i] = r.ramp[i - 1] + 0.5f * (r.step[i - 1] + r.step[i]) / kEntriesPerCutoff;
    return r;
  }();
  return kResponses;
}

glm::vec3 vector_of(const FeltAcceleration& force) { return {force.forward, force.left, force.up}; }

// Updates `found` with the larger of each value.
void take(const Jolt& one, Jolt& found) {
  found.forward = std::max(found.forward, one.forward);
  found.left = std::max(found.left, one.left);
  found.up = std::max(found.up, one.up);
  found.fastest = std::max(found.fastest, one.fastest);
  if (one.total > found.total) found.total = one.total, found.car = one.car, found.speed = one.speed;
}

// Collects the largest values of a difference of felt g.
class LargestFelt {
 public:
  void add(glm::vec3 felt) {
    most_ = glm::max(most_, glm::abs(felt));
    square_ = std::max(square_, glm::dot(felt, felt));
  }
  Jolt jolt(const JointPassage& passage) const {
    return {most_.x, most_.y, most_.z, std::sqrt(square_), passage.car, passage.speed, std::abs(passage.speed)};
  }

 private:
  glm::vec3 most_{0};
  float square_ = 0;
};

// Returns the difference that some consecutive passages of a car make together, with the change of felt g between them,
// as a jolt of `passage`.
Jolt together(std::span<const JointPassage* const> passed, const JointPassage& passage, double cutoff) {
  const LowPassResponses& r = responses();
  const double start = passed.front()->time, whole = passed.back()->time - start;
  const auto entries = [&](double time) { return static_cast<float>(time * cutoff * kEntriesPerCutoff); };
  LargestFelt largest;
  for (float x = 0; x < static_cast<float>(LowPassResponses::kCount) + entries(whole); ++x) {
    glm::vec3 felt(0);
    for (std::size_t i = 0; i < passed.size(); ++i) {
      const JointPassage& here = *passed[i];
      const float since = x - entries(here.time - start);
      felt += r.impulse_at(since) * static_cast<float>(cutoff) * vector_of(here.impulse) +
              r.step_at(since) * vector_of(here.step);
      if (i + 1 == passed.size()) break;
      const JointPassage& next = *passed[i + 1];
      const glm::vec3 change = vector_of(next.before) - vector_of(here.before) - vector_of(here.step);
      const auto took = static_cast<float>((next.time - here.time) * cutoff);
      if (took > 0) felt += (r.ramp_at(since) - r.ramp_at(since - took * kEntriesPerCutoff)) / took * change;
    }
    largest.add(felt);
  }
  return largest.jolt(passage);
}

// Returns the passages of a car that a step at passage i may count together with: those within 1 / (2 cutoff) and
// kMostBeside of it, if one of them steps the other way; else i alone.
struct PassageRange {
  std::size_t first, last;
};
PassageRange beside(std::span<const JointPassage* const> passed, std::size_t i, double cutoff) {
  constexpr std::size_t kMostBeside = 3;  // on either side
  const auto near = [&](std::size_t k) { return std::abs(passed[k]->time - passed[i]->time) <= 0.5 / cutoff; };
  const glm::vec3 step = vector_of(passed[i]->step);
  PassageRange found{i, i};
  if (glm::length(step) < kLeastStep) return found;
  while (found.first > 0 && i - found.first < kMostBeside && near(found.first - 1)) --found.first;
  while (found.last + 1 < passed.size() && found.last - i < kMostBeside && near(found.last + 1)) ++found.last;
  for (std::size_t k = found.first; k <= found.last; ++k)
    if (const glm::vec3 other = vector_of(passed[k]->step);
        glm::length(other) >= kLeastStep && glm::dot(other, step) < 0)
      return found;
  return {i, i};
}

}  // namespace

Jolt jolt_of(const JointPassage& passage, double cutoff) {
  const LowPassResponses& r = responses();
  const glm::vec3 impulse = static_cast<float>(cutoff) * vector_of(passage.impulse), step = vector_of(passage.step);
  LargestFelt largest;
  for (std::size_t i = 0; i < r.impulse.size(); ++i) largest.add(r.impulse[i] * impulse + r.step[i] * step);
  return largest.jolt(passage);
}

std::vector<Jolt> passage_jolts(const SimulatedRide& simulated, double cutoff) {
  std::vector<std::vector<const JointPassage*>> cars(static_cast<std::size_t>(simulated.start.cars));
  std::vector<Jolt> found;
  std::vector<std::size_t> places;  // of each passage among its car's
  for (const JointPassage& passage : simulated.passages) {
    std::vector<const JointPassage*>& passed = cars[static_cast<std::size_t>(passage.car)];
    places.push_back(passed.size()), passed.push_back(&passage), found.push_back(jolt_of(passage, cutoff));
  }
  for (std::size_t n = 0; n < found.size(); ++n) {
    const JointPassage& passage = simulated.passages[n];
    const std::span<const JointPassage* const> passed = cars[static_cast<std::size_t>(passage.car)];
    const PassageRange near = beside(passed, places[n], cutoff);
    for (std::size_t first = near.first; first <= places[n]; ++first)
      for (std::size_t last = std::max(first + 1, places[n]); last <= near.last; ++last)
        if (const Jolt all = together(passed.subspan(first, last - first + 1), passage, cutoff);
            all.total < found[n].total)
          found[n] = all;
  }
  return found;
}

std::vector<Jolt> jolts(const SimulatedRide& simulated, double cutoff) {
  std::vector<Jolt> found;
  const std::vector<Jolt> passages = passage_jolts(simulated, cutoff);
  for (std::size_t i = 0; i < passages.size(); ++i) {
    const std::size_t knot = simulated.passages[i].knot;
    if (knot >= found.size()) found.resize(knot + 1);
    take(passages[i], found[knot]);
  }
  return found;
}

std::optional<double> fastest_step(const world::Document& document, std::span<const Jolt> jolts, std::size_t knot) {
  if (!(knot < jolts.size() && jolts[knot].fastest > 0)) return std::nullopt;
  const std::vector<world::Entity>& segments = document.track.segments;
  const curve::Cubic before = world::cubic_of(document, segments[(knot + segments.size() - 1) % segments.size()]),
                     after = world::cubic_of(document, segments[knot]);
  return g_step(curve::joint(before, after).curvature_jump, jolts[knot].fastest);
}

std::optional<double> largest_step(const world::Document& document, std::span<const Jolt> jolts) {
  std::optional<double> most;
  for (std::size_t knot = 0; knot < jolts.size(); ++knot) most = std::max(most, fastest_step(document, jolts, knot));
  return most;
}

}  // namespace coaster::sim
