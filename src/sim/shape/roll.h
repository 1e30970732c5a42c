// Roll along a segment, and the spins of knots that follow from the twists on both sides. The spin is the rate at which
// the track's frame turns about the tangent against the rotation-minimising one: it is the same on both sides of a
// knot, so the roll rate of a train is continuous over every joint.
#pragma once

#include <span>

#include "world/document.h"

namespace coaster::sim {

// The angle of the track's frame against the rotation-minimising one from the segment's start: a cubic Hermite over arc
// length.
struct Roll {
  double length = 0;             // m
  double twist = 0;              // rad, the angle at the end
  double from = 0, to = 0;       // rad/m, spin of the first and the second knot
  double angle(double s) const;  // rad at s in [0, length] m: 0 at the start, exactly `twist` at the end
  double spin(double s) const;   // rad/m, its derivative by s
  double slope(double s) const;  // rad/m^2, its second derivative
};

// Returns the spin of a knot between two segments of these twists (rad) and lengths (m), rad/m: a weighted harmonic
// mean of their mean spins, or 0 where they differ in sign. Then roll does not overshoot the knots: Fritsch and
// Butland, SIAM J. Sci. Stat. Comput. 5 (1984) 300. 0 below kLeastSpin and beside segments of no length.
double automatic_spin(double twist_before, double length_before, double twist_after, double length_after);
inline constexpr double kLeastSpin = 1e-6;  // rad/m: rounding of the knots' `up` is less

// Returns the roll of a segment.
Roll roll_of(const world::Document& document, world::Entity segment);

// Sets the spin of those `knots` that have an automatic one, from the twists on both sides. It is 0 at the ends of an
// open track. Linear in the track's length; shapes the segments beside those knots once more, on all cores.
void set_automatic_spins(world::Document& document, std::span<const world::Entity> knots);
// Sets the spin of every knot of the track.
void set_automatic_spins(world::Document& document);

}  // namespace coaster::sim
