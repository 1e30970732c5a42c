#include "sim/shape/roll.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "sim/shape/derived.h"

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

bool set_automatic_spins(const Derived& derived, std::span<const world::Entity> knots, world::Document& document) {
  if (knots.empty()) return false;
  std::vector<world::Entity> wanted(knots.begin(), knots.end());
  std::sort(wanted.begin(), wanted.end());
  const world::Track& track = document.track;
  const std::size_t segments = derived.order.size();
  bool changed = false;
  for (std::size_t i = 0; i < track.knots.size(); ++i) {
    if (!std::binary_search(wanted.begin(), wanted.end(), track.knots[i])) continue;
    const world::Knot& knot = world::knot(document, track.knots[i]);
    if (knot.spin_kind != world::SpinKind::automatic) continue;
    float spin = 0;
    if (track.closed || (i > 0 && i < segments)) {
      const Roll &before = derived.shape_at(i > 0 ? i - 1 : segments - 1).roll, &after = derived.shape_at(i).roll;
      spin = static_cast<float>(automatic_spin(before.twist, before.length, after.twist, after.length));
    }
    if (spin == knot.spin) continue;
    document.entities.get<world::Knot>(track.knots[i]).spin = spin;
    changed = true;
  }
  return changed;
}

void set_automatic_spins(world::Document& document) {
  set_automatic_spins(shapes_of(document), document.track.knots, document);
}

}  // namespace coaster::sim
