#include "sim/plan/banking.h"

#include <algorithm>
#include <optional>

#include "curve/continuity.h"
#include "curve/frames.h"
#include "world/topology.h"

namespace coaster::sim {
namespace {

using glm::dvec3;

// Returns the mean of the curvatures on both sides of knot i.
dvec3 mean_bend(const DerivedTrack& derived, std::size_t i) {
  const std::size_t count = derived.order.size();
  const auto bend_at = [&](std::size_t index, double t) {
    return curve::curvature_vector(derived.shape_at(index).key.cubic, t);
  };
  dvec3 sum(0);
  int sides = 0;
  if (i > 0 || derived.closed) sum += bend_at(i > 0 ? i - 1 : count - 1, 1.0), ++sides;
  if (i < count) sum += bend_at(i, 0.0), ++sides;
  return sides > 0 ? sum / static_cast<double>(sides) : sum;
}

// Returns how far the train has been by each sample, m.
std::vector<double> furthest_of(const SimulatedRide& simulated) {
  std::vector<double> furthest;
  for (const RideSample& sample : simulated.samples)
    furthest.push_back(furthest.empty() ? sample.travelled : std::max(furthest.back(), sample.travelled));
  return furthest;
}

// Returns the first sample at which the middle car is past `distance` (m from the track's start).
std::optional<std::size_t> passing(const SimulatedRide& simulated, const std::vector<double>& furthest,
                                   double distance) {
  const double middle = simulated.start.front - 0.5 * (simulated.start.cars - 1) * simulated.start.spacing;
  const double ahead = within_lap(distance - middle, simulated.track_length, simulated.closed);
  const auto first = std::lower_bound(furthest.begin(), furthest.end(), ahead);
  if (ahead < 0 || first == furthest.end()) return std::nullopt;
  return static_cast<std::size_t>(first - furthest.begin());
}

}  // namespace

std::vector<glm::vec3> banked_ups(const world::Document& document, const DerivedTrack& derived,
                                  const SimulatedRide& simulated) {
  const std::vector<double> furthest = furthest_of(simulated);
  std::vector<glm::vec3> ups;
  for (std::size_t i = 0; i < document.track.knots.size(); ++i) {
    const world::Knot& knot = world::knot(document, document.track.knots[i]);
    ups.push_back(knot.up);
    if (i >= derived.starts.size()) continue;
    const auto sample = passing(simulated, furthest, derived.starts[i]);
    if (!sample) continue;
    const double speed = simulated.samples[*sample].speed;
    const dvec3 tangent(knot.tangent), felt = speed * speed * mean_bend(derived, i) + dvec3(0, world::kGravity, 0);
    dvec3 across = curve::across(felt, tangent);
    if (glm::length(across) < kLeastFelt * world::kGravity) continue;
    if (glm::dot(across, dvec3(knot.up)) < 0) across = -across;
    ups.back() = glm::vec3(glm::normalize(across));
  }
  return ups;
}

int bank_knots(world::Document& document, const DerivedTrack& derived, const SimulatedRide& simulated) {
  const std::vector<glm::vec3> ups = banked_ups(document, derived, simulated);
  int turned = 0;
  for (std::size_t i = 0; i < ups.size(); ++i) {
    world::Knot& knot = document.entities.get<world::Knot>(document.track.knots[i]);
    if (knot.up == ups[i]) continue;
    knot.up = ups[i];
    world::orthonormalise(knot);
    ++turned;
  }
  return turned;
}

}  // namespace coaster::sim
