#include "sim/shape/roll.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/cancellable_job.h"
#include "base/parallel.h"
#include "sim/shape/derived_track.h"

namespace coaster::sim {
namespace {

constexpr double kShortSegment = 1e-6;  // m

}  // namespace

double Roll::angle(double s) const {
  if (!(length > 0)) return 0;
  const double u = s / length, rest = 1.0 - u;
  return twist * (u * u * (3.0 - 2.0 * u)) + length * u * rest * (from * rest - to * u);
}

double Roll::spin(double s) const {
  if (!(length > 0)) return from;
  const double u = s / length, rest = 1.0 - u;
  return 6.0 * u * rest * (twist / length) + from * rest * (1.0 - 3.0 * u) + to * u * (3.0 * u - 2.0);
}

double Roll::slope(double s) const {
  if (!(length > 0)) return 0;
  const double u = s / length;
  return ((6.0 - 12.0 * u) * (twist / length) + from * (6.0 * u - 4.0) + to * (6.0 * u - 2.0)) / length;
}

double automatic_spin(double twist_before, double length_before, double twist_after, double length_after) {
  if (length_before < kShortSegment || length_after < kShortSegment) return 0;
  const double before = twist_before / length_before, after = twist_after / length_after;
  if (!(before * after > 0)) return 0;
  // The shorter segment counts more.
  const double a = length_before + 2.0 * length_after, b = 2.0 * length_before + length_after;
  const double mean = (a + b) / (a / before + b / after);
  return std::abs(mean) < kLeastSpin ? 0 : std::clamp<double>(mean, -world::kMaxSpin, world::kMaxSpin);
}

void set_automatic_spins(world::Document& document, std::span<const world::Entity> knots) {
  if (knots.empty()) return;
  std::vector<world::Entity> wanted(knots.begin(), knots.end());
  std::sort(wanted.begin(), wanted.end());
  const world::Track& track = document.track;
  const std::size_t segments = track.segments.size();
  // The knots, and the segment before each and after it.
  std::vector<std::size_t> places, beside;
  const auto inside = [&](std::size_t i) { return track.closed || (i > 0 && i < segments); };
  const auto before = [&](std::size_t i) { return i > 0 ? i - 1 : segments - 1; };
  for (std::size_t i = 0; i < track.knots.size(); ++i) {
    if (!std::binary_search(wanted.begin(), wanted.end(), track.knots[i]) ||
        world::knot(document, track.knots[i]).spin_kind != world::SpinKind::automatic)
      continue;
    places.push_back(i);
    if (inside(i)) beside.insert(beside.end(), {before(i), i});
  }
  std::sort(beside.begin(), beside.end());
  beside.erase(std::unique(beside.begin(), beside.end()), beside.end());
  std::vector<Roll> rolls(beside.size());
  constexpr std::size_t kPart = 64;  // segments
  base::in_parts(beside.size(), kPart, base::cores(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end && !base::interrupted(); ++k)
      rolls[k] = roll_of(document, track.segments[beside[k]]);
  });
  const auto roll = [&](std::size_t segment) -> const Roll& {
    return rolls[static_cast<std::size_t>(std::lower_bound(beside.begin(), beside.end(), segment) - beside.begin())];
  };
  for (const std::size_t i : places) {
    float spin = 0;
    if (inside(i)) {
      const Roll &a = roll(before(i)), &b = roll(i);
      spin = static_cast<float>(automatic_spin(a.twist, a.length, b.twist, b.length));
    }
    document.entities.get<world::Knot>(track.knots[i]).spin = spin;
  }
}

void set_automatic_spins(world::Document& document) { set_automatic_spins(document, document.track.knots); }

}  // namespace coaster::sim
