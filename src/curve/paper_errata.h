// The paper's wrong claims about single curves next to the correct values, in numbers. Claims that need a track or a
// ride are in sim/study/track_errata.h.
#pragma once

#include "curve/cubic.h"

namespace coaster::curve {

// Paper erratum: Gravesen's estimate is the mean of chord and control polygon, not half the polygon multiplied by the
// chord.
struct GravesenClaim {
  double product;  // m^2, half the polygon times the chord, as in the paper
  double mean;     // m, (chord + polygon) / 2: off by at most (polygon - chord) / 2
};
GravesenClaim gravesen_claim(const Cubic& cubic);

// Paper erratum: B(0) + i dB, one difference for all steps, is a straight line. Returns the largest distance in m of a
// vertex B(0) + i (B(1/n) - B(0)) from the vertex B(i/n). `steps` >= 1. Costs one evaluation per step, at most 4096.
double line_claim(const Cubic& cubic, int steps);

// Paper erratum: the Frenet-Serret normal flips across an inflection; the rotation-minimising frame, by definition,
// does not turn about the tangent.
struct FlipClaim {
  double t;             // where the normal turns most
  double frenet_angle;  // rad, how far it turns about the tangent within 1/32 of the segment around t (binormal_turns)
  bool defined;         // false on a straight line: there is no normal
};
FlipClaim flip_claim(const Cubic& cubic);

// Paper erratum: the lines between the control points are no "pen containing the curve". The curve can leave a polygon
// that crosses itself or is not convex; it never leaves the convex hull. Returns how far in m the curve leaves the
// closed control polygon, seen along its mean normal.
double pen_claim(const Cubic& cubic);

}  // namespace coaster::curve
