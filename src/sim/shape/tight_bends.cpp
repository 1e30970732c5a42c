#include "sim/shape/tight_bends.h"

#include <algorithm>
#include <limits>

#include <fmt/format.h>

#include "curve/tight_places.h"
#include "sim/shape/rails.h"

namespace coaster::sim {

std::vector<TightBend> tight_bends_of(const SegmentShape& shape) {
  const curve::Cubic& cubic = shape.key.cubic;
  std::vector<TightBend> bends;
  double apart = curve::radius_at(cubic, 0);
  for (const curve::TightPlace& place : curve::tight_places(cubic, kLeastRadius)) {
    const double at = shape.arc.distance(place.t);
    const TightBend bend{at, at, at, place.radius, glm::vec3(rails_point(shape, place.t))};
    const bool joined = apart < kLeastRadius;
    apart = place.apart;
    if (!joined || (!bends.empty() && place.reversal)) bends.push_back(bend);
    else if (bends.empty()) bends.push_back(bend), bends.back().from = 0;
    else if (bend.radius < bends.back().radius) bends.back() = {bends.back().from, at, at, bend.radius, bend.place};
  }
  if (!bends.empty() && apart < kLeastRadius) bends.back().to = shape.arc.length();
  return bends;
}

std::vector<TightBend> tight_bends_of(const Derived& derived) { return Folds(tight_bends_of).update(derived); }

const TightBend& tightest(std::span<const TightBend> bends) {
  return *std::min_element(bends.begin(), bends.end(),
                           [](const TightBend& a, const TightBend& b) { return a.radius < b.radius; });
}

std::string tight_text(std::span<const TightBend> bends) {
  if (bends.empty()) return {};
  const TightBend& worst = tightest(bends);
  const std::string what =
      worst.radius > 0 ? fmt::format("a radius of {:.3g} m", worst.radius) : "the direction reverses";
  return fmt::format("{} tight bend{}: {} at {:.1f} m", bends.size(), bends.size() == 1 ? "" : "s", what, worst.at);
}

double least_radius(const Derived& derived) {
  double least = std::numeric_limits<double>::infinity();
  for (const world::Entity segment : derived.order)
    for (const curve::TightPlace& place : curve::tight_places(derived.shape(segment).key.cubic, least))
      least = std::min(least, place.radius);
  return least;
}

}  // namespace coaster::sim
