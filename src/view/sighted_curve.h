// One cubic as seen from a pixel: all the places where it comes nearest to it.
#pragma once

#include <array>

#include "curve/cubic.h"
#include "view/beam.h"

namespace coaster::view {

// A place where the distance on screen from the pixel is least among its neighbours on the curve, or where the visible
// part ends.
struct SightedPlace {
  double t = 0;
  double square = 0;  // px^2, of the distance
  double depth = 0;   // m along the line of sight's depth axis
};
inline constexpr int kMaxSightedPlaces = 24;
struct SightedPlaces {
  std::array<SightedPlace, kMaxSightedPlaces> items;
  int count = 0;
  const SightedPlace* begin() const { return items.data(); }
  const SightedPlace* end() const { return items.data() + count; }
};

using SightedControls = std::array<Sighted, 4>;
SightedControls sighted(const curve::Cubic& cubic, const Beam& beam);

// False when all of the curve that is in front of the eye is certainly further than `limit` pixels (finite) away.
bool may_come_near(const SightedControls& controls, double limit);

// Places in the order of t, each t to 1e-9 or, at a stationary inflection, where rounding puts it. The derivative of
// the squared distance has the sign of N = (U U' + V V') W - (U^2 + V^2) W', of degree 8: its Bernstein coefficients
// bound the number of its roots (Descartes' rule), so none is missed however sharply the curve turns on screen. What is
// not visible (behind the eye, beyond the planes) counts for nothing.
SightedPlaces nearest_places(const SightedControls& controls);

// The sign of the squared distance's derivative towards greater t at an end, 0 or 1, of a curve that is visible there.
int slope_at_end(const SightedControls& controls, int end);

}  // namespace coaster::view
