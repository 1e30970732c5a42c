#include "sim/study/surroundings.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>

#include "base/cancellable_job.h"
#include "sim/solids/coaster_form.h"
#include "sim/solids/track_mesh.h"
#include "sim/study/ratings.h"

namespace coaster::sim {
namespace {

using glm::dvec3;

constexpr double kGroundStep = 2;  // m of the ride between two looks

// The directions in which earth is looked for, as cosine and sine over the horizon: from one side over the top to the
// other, in steps of 22.5 degrees.
constexpr double kSine[] = {0, 0.38268343236508977, 0.70710678118654752, 0.92387953251128676, 1};
constexpr int kWays = 9;
glm::dvec2 way(int i) {
  const int from_level = i < 5 ? i : 8 - i;
  return {(i < 5 ? 1 : -1) * kSine[4 - from_level], kSine[from_level]};
}

// The riders of the first car at one place.
struct HeadOnLand {
  const Ground& ground;
  dvec3 head, across;  // across: unit, level
  const Tunnel* tunnel;

  // Above an open cut is no earth; in a tunnel the tube is what one sees of it.
  bool earth_within(double reach) const {
    if (tunnel != nullptr) return reach >= ground.room().tube;
    for (int i = 0; i < kWays; ++i) {
      const dvec3 to = way(i).x * across + dvec3(0, way(i).y, 0);
      for (const double part : {1.0 / 3, 2.0 / 3, 1.0}) {
        const dvec3 p = head + part * reach * to;
        if (p.y < ground.height(p.x, p.z)) return true;
      }
    }
    return false;
  }
  bool water_within(double reach) const {
    if (tunnel != nullptr || !(ground.height(head.x, head.z) < ground.water())) return false;
    return head.y < ground.water() + reach;
  }
};

HeadOnLand head_at(const DerivedTrack& derived, const Ground& ground, double distance) {
  const TrackPlace place = place_at(derived, distance);
  const Ring ring = ring_at(derived.shape_at(place.index), place.s);
  const dvec3 forward = ring.frame.forward, left = ring.frame.left();
  dvec3 across(forward.z, 0, -forward.x);
  if (glm::length(across) < 0.2) across = {left.x, 0, left.z};
  const double length = glm::length(across);
  return {ground, ring.place(0, form_of(derived.made.kind).head), length > 1e-6 ? across / length : dvec3(1, 0, 0),
          ground.tunnel_at(distance)};
}

}  // namespace

Surroundings surroundings_of(const SimulatedRide& simulated, const DerivedTrack& derived, const Ground& ground,
                             const Plants& plants) {
  Surroundings around;
  if (ground.plain() || derived.order.empty() || simulated.samples.empty()) return around;
  std::set<const Tunnel*> passed;
  const Tunnel* before = nullptr;
  double next = 0, last_miss = -std::numeric_limits<double>::infinity();
  int looks = 0, close = 0, inside = 0;
  for (std::size_t i = 0; i < simulated.samples.size() && !base::interrupted(); ++i) {
    const RideSample& sample = simulated.samples[i];
    if (sample.travelled < next) continue;
    if (simulated.closed && sample.travelled > derived.length) break;
    next = sample.travelled + kGroundStep;
    const HeadOnLand here = head_at(derived, ground, simulated.distance(i));
    const double tree = here.tunnel == nullptr ? plants.distance(here.head, kCloseBy) : kCloseBy;
    const bool portal = looks > 0 && here.tunnel != before;
    ++looks, before = here.tunnel;
    if (here.tunnel != nullptr) passed.insert(here.tunnel), ++inside;
    if (tree < kCloseBy || here.water_within(kCloseBy) || here.earth_within(kCloseBy)) ++close;
    if (sample.speed < kSlowestMiss) continue;
    if (!portal && !(tree < kNearTree) && !here.water_within(kNearWater) && !here.earth_within(kNearEarth)) continue;
    if (sample.travelled - last_miss > kMissApart) ++around.near_misses;
    last_miss = sample.travelled;
  }
  around.tunnels = static_cast<int>(passed.size()), around.in_tunnels = kGroundStep * inside;
  around.close = looks > 0 ? static_cast<double>(close) / looks : 0.0;
  return around;
}

}  // namespace coaster::sim
