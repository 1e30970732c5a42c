// The smallest change that makes the joint of two cubics G2 (one curvature): a constrained least-squares problem in the
// control points. Independent of documents: edit/perform/joint_repair.h maps knots to it, applies the limits and checks
// the rounded result.
#pragma once

#include <cstdint>

#include "curve/cubic.h"

namespace coaster::curve {

// The far end of one of the two segments. Its two control points are `anchor` and anchor + direction * length.
struct G2Side {
  glm::dvec3 anchor{0};           // m, the far end of the segment
  glm::dvec3 direction{1, 0, 0};  // unit, from the anchor to its own handle
  double length = 1;              // m, > 0
  bool length_fixed = true;       // false: the handle may change its length along `direction`
  // The constraint at the far end. curvature: the curvature vector stays `curvature` (the far joint is G2 and stays
  // G2). handle: the joint's handle on this side does not move (the far joint is C2 and stays C2).
  enum class FarEndConstraint : std::uint8_t { nothing, curvature, handle } keep = FarEndConstraint::nothing;
  glm::dvec3 curvature{0};  // 1/m, perpendicular to `direction`
};

// The joint: in_handle, position and out_handle lie on one line, in this order (G1).
struct G2Problem {
  glm::dvec3 in_handle{0}, position{0}, out_handle{0};  // m
  bool equal_lengths = false;                           // the joint's handles keep equal lengths (C1)
  bool position_fixed = false;                          // the joint does not move
  G2Side before, after;
};

enum class G2Outcome : std::uint8_t {
  solved,
  degenerate,      // a handle of zero length, or values that are not finite
  no_convergence,  // the conditions contradict each other, or no solution is near; handles would fall below 1/16 of
                   // their length
};

struct G2Solution {
  G2Outcome outcome = G2Outcome::degenerate;
  glm::dvec3 in_handle{0}, position{0}, out_handle{0};  // m, on one line
  double before_length = 0, after_length = 0;           // m, of the far handles
  double movement = 0;  // m, root of the sum of squared movements of the (up to five) control points
  int iterations = 0;
};

// Returns the control points nearest to the given ones (least sum of squared movements, a local minimum reached from
// the start values) for which the curvature vectors of both sides agree and the constraints of the sides hold.
// Sequential quadratic programming with Lagrange multipliers: at most 9 unknowns and 11 conditions, at most 60
// iterations of about 6 us, usually 5. Conditions are met to 1e-8 of the distance between the handles. Uses only + - *
// / and sqrt: the same bits everywhere. The condition, from k = (2/3) |d0 x d1| / |d0|^3 at both ends: out^2 (a - p) -
// in^2 (b - p) is parallel to the tangent, with a, b the far handles, p the joint, in and out its handle lengths.
G2Solution solve_g2(const G2Problem& problem);

}  // namespace coaster::curve
