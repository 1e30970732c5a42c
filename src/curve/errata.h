// Numbers of the paper's wrong claims about curves beside the right ones, for one cubic. What needs a track or a ride
// is in sim/study/live_errata.h.
#pragma once

#include "curve/cubic.h"

namespace coaster::curve {

// Paper erratum: Gravesen's estimate is the mean of chord and control polygon, not half the polygon multiplied by the
// chord.
struct GravesenClaim {
  double product;  // m^2, half the polygon times the chord, as the paper has it
  double mean;     // m, (chord + polygon) / 2
  double length;   // m, the true length
  double bound;    // m, (polygon - chord) / 2: how far the mean can be off
};
GravesenClaim gravesen_claim(const Cubic& cubic);

// Paper erratum: B(0) + i dB, one difference for all steps, is a straight line.
struct LineClaim {
  double distance;  // m, the largest distance of a vertex B(0) + i (B(1/n) - B(0)) from the vertex B(i/n)
  double t;         // where
};
// `steps` >= 1. Cost: one evaluation a step, at most 4096 are looked at.
LineClaim line_claim(const Cubic& cubic, int steps);

// Paper erratum: the Frenet-Serret normal flips across an inflection; the rotation-minimising frame does not.
struct FlipClaim {
  double t;             // the place where the normal turns fastest
  double frenet_angle;  // rad, by which the Frenet normal turns about the tangent from t - 1/64 to t + 1/64 (cut at the
                        // ends)
  double minimising_angle;  // rad, by which the rotation-minimising frame turns about the tangent there: 0 but for
                            // rounding
  bool defined;             // false on a straight line: no normal at all
};
FlipClaim flip_claim(const Cubic& cubic);

// Paper erratum: the lines between the control points are no "pen containing the curve": the curve can leave a polygon
// that crosses itself or is not convex; the convex hull it never leaves.
struct PenClaim {
  double outside;  // m, how far the curve goes outside the closed control polygon, seen along the polygon's mean normal
  double outside_hull;  // m, the same against the hull of the four points: 0 but for rounding
};
PenClaim pen_claim(const Cubic& cubic);

}  // namespace coaster::curve
