// Cubic Bezier spans through the ideal curve of an element: as few as keep it within the tolerances, with one curvature
// at every joint (G2).
#pragma once

#include <vector>

#include "sim/plan/element_path.h"
#include "world/document.h"

namespace coaster::sim {

// What a fit keeps, in float, where coordinates are exact enough for it (to 2 km from the origin). Distances from the
// ideal curve, the angle between what is up, and the jump of the curvature vector at joints: a fifth of what counts as
// G2 (curve/continuity.h).
inline constexpr double kElementDistance = 0.01;  // m
inline constexpr double kElementRoll_deg = 1.0;
inline constexpr double kElementJump = 2e-4;  // 1/m

struct ElementFit {
  // From the start of the curve to its end: one more than there are spans. The first has the start's position and
  // tangent, and an outgoing length; the last ends straight. Joints are aligned (G1 by construction, G2 by their
  // shape). No segment needs whole turns of roll.
  std::vector<world::Knot> knots;
  double error = 0;       // m, the largest distance of the ideal curve's points from the spans
  double roll_error = 0;  // rad, the largest angle about the tangent between the spans' frames and the ideal curve's up
  double jump = 0;  // 1/m, the largest jump of curvature: at inner joints, against the ideal curve's at its start, and
                    // against none at its end
  bool within = false;  // all three within the tolerances, to what float can tell
};

// Knots lie on the ideal curve, at the ends of its pieces and evenly between them; then those that are not needed are
// left out. Each span gets the handle lengths for which it has the curve's curvature at both ends within the plane of
// the bend: two quadratic equations, by Gauss-Newton (de Boor, Hollig, Sabin 1987, "High accuracy geometric Hermite
// interpolation", doi 10.1016/0167-8396(87)90002-1: sixth order for plane curves). What torsion leaves of a jump of
// curvature at the joints is taken away by turning the inner tangents: a block-tridiagonal Newton iteration. Needs at
// least 2 points. Some ms; the same bits everywhere.
ElementFit fit_element(const ElementCurve& curve);

}  // namespace coaster::sim
