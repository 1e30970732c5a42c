// One cubic as seen from a pixel: all positions with a local minimum of the distance.
#pragma once

#include <array>

#include "curve/cubic.h"
#include "view/pick_cone.h"

namespace coaster::view {

// A local minimum of the distance on screen from the pixel, or an end of the visible part.
struct SightedPlace {
  double t = 0;
  double square = 0;  // px^2, squared distance
  double depth = 0;   // m, depth from the eye
};
inline constexpr int kMaxSightedPlaces = 24;
struct SightedPlaces {
  std::array<SightedPlace, kMaxSightedPlaces> items;
  int count = 0;
  const SightedPlace* begin() const { return items.data(); }
  const SightedPlace* end() const { return items.data() + count; }
};

using SightedControls = std::array<PixelRelative, 4>;
SightedControls sighted(const curve::Cubic& cubic, const PixelBeam& beam);

// Returns false if all of the curve in front of the eye is certainly more than `limit` pixels (finite) away.
bool may_come_near(const SightedControls& controls, double limit);

// Returns the positions in the order of t, each t to 1e-9 or, at a stationary inflection, to rounding. The derivative
// of the squared distance has the sign of N = (U U' + V V') W - (U^2 + V^2) W', of degree 8. Its Bernstein coefficients
// bound the number of its roots (Descartes' rule), so none is missed, however sharply the curve turns on screen.
// Invisible parts (behind the eye, beyond the planes) do not count.
SightedPlaces nearest_places(const SightedControls& controls);

// Returns the sign of the squared distance's derivative towards greater t at an end, 0 or 1, of a curve that is visible
// there.
int slope_at_end(const SightedControls& controls, int end);

}  // namespace coaster::view
