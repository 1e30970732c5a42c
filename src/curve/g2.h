// The smallest change that gives a joint of two cubics one curvature (G2): a constrained least-squares problem in the
// control points. Knows no documents: edit/perform/joint_repair.h maps knots to it, keeps the limits and checks the
// rounded result.
#pragma once

#include <cstdint>

#include "curve/cubic.h"

namespace coaster::curve {

// What the far end of one of the two segments allows. Its two control points are `anchor` and anchor + direction *
// length.
struct G2Side {
  glm::dvec3 anchor{0};           // m, the far end of the segment
  glm::dvec3 direction{1, 0, 0};  // unit, from the anchor to its own handle
  double length = 1;              // m, > 0
  bool length_fixed = true;       // false: the handle may slide along `direction`
  // What must stay at the far end. curvature: the curvature vector there stays `curvature` (the far joint is G2 and
  // stays so); handle: the handle of the joint on this side does not move at all (the far joint is C2 and stays so).
  enum class Keep : std::uint8_t { nothing, curvature, handle } keep = Keep::nothing;
  glm::dvec3 curvature{0};  // 1/m, perpendicular to `direction`
};

// The joint: in_handle, position and out_handle lie on one line, in this order (G1).
struct G2Problem {
  glm::dvec3 in_handle{0}, position{0}, out_handle{0};  // m
  bool equal_lengths = false;                           // the joint's handles stay equally long (C1)
  bool position_fixed = false;                          // the joint stays where it is
  G2Side before, after;
};

enum class G2Outcome : std::uint8_t {
  solved,
  degenerate,      // a handle of no length, or numbers that are not finite
  no_convergence,  // the conditions contradict each other, or no solution is near; handles would fall below 1/16 of
                   // their length
};

struct G2Solution {
  G2Outcome outcome = G2Outcome::degenerate;
  glm::dvec3 in_handle{0}, position{0}, out_handle{0};  // m, on one line
  double before_length = 0, after_length = 0;           // m, of the far handles
  double movement = 0;  // m, root of the summed squared movements of the (up to five) control points
  int iterations = 0;
};

// The control points nearest to the given ones (least sum of squared movements, a local minimum reached from where they
// are) for which the curvature vectors of both sides agree and the sides keep what they must: sequential quadratic
// programming with Lagrange multipliers, at most 9 unknowns and 11 conditions, at most 60 iterations of about 6 us,
// mostly 5. Conditions are met to 1e-8 of the distance between the handles. Uses + - * / and sqrt alone: the same bits
// everywhere. The condition, from k = (2/3) |d0 x d1| / |d0|^3 at both ends: out^2 (a - p) - in^2 (b - p) is parallel
// to the tangent, with a, b the far handles, p the joint, in and out its handles' lengths.
G2Solution solve_g2(const G2Problem& problem);

}  // namespace coaster::curve
