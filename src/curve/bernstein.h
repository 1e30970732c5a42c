// Bézier curves of any degree n: Bernstein's basis and de Casteljau's triangle. Written for clarity and accuracy, not
// speed. Used by the pictures of the construction and by the exact point of a cubic.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "curve/cubic.h"

namespace coaster::curve {

// Writes B_(i,n)(t) = C(n,i) t^i (1-t)^(n-i) for i = 0..n to the n + 1 entries of `weights`, n >= 0. For t in [0,1]
// each is in [0,1] and they sum to 1. Uses the recurrence B_(i,n) = (1-t) B_(i,n-1) + t B_(i-1,n-1), so no binomial can
// overflow; relative error about n ulps.
template <class Real>
void bernstein_basis(Real t, std::span<Real> weights) {
  if (weights.empty()) return;
  weights[0] = Real(1);
  for (std::size_t n = 1; n < weights.size(); ++n) {
    weights[n] = t * weights[n - 1];
    for (std::size_t i = n - 1; i > 0; --i) weights[i] = (Real(1) - t) * weights[i] + t * weights[i - 1];
    weights[0] *= Real(1) - t;
  }
}

// Returns all levels of de Casteljau's triangle in one row: the n + 1 controls, then n points, n - 1, ..., 1:
// (n+1)(n+2)/2 in all. The last is the point of the curve. The first points of the levels are the controls of [0,t];
// the last points, in reverse order, those of [t,1].
template <class Real, class G2Unknowns>
std::vector<G2Unknowns> de_casteljau_levels(std::span<const G2Unknowns> controls, Real t) {
  std::vector<G2Unknowns> all(controls.begin(), controls.end());
  all.reserve(controls.size() * (controls.size() + 1) / 2);
  for (std::size_t level = controls.size(), from = 0; level > 1; from += level, --level)
    for (std::size_t i = from; i + 1 < from + level; ++i) all.push_back((Real(1) - t) * all[i] + t * all[i + 1]);
  return all;
}

// Returns the point at t by de Casteljau's method; exactly the first control at t = 0 and the last at t = 1. O(n^2),
// stable for t in [0,1]. Overwrites `row`, which holds the controls of [t,1] afterwards.
template <class Real, class G2Unknowns>
G2Unknowns de_casteljau_in_place(std::span<G2Unknowns> row, Real t) {
  for (std::size_t level = row.size(); level > 1; --level)
    for (std::size_t i = 0; i + 1 < level; ++i) row[i] = (Real(1) - t) * row[i] + t * row[i + 1];
  return row[0];
}
std::array<glm::dvec3, 4> controls(const Cubic& cubic);

// De Casteljau's construction of a point on a cubic, level by level; Barrett 2012, section 3.2. t in [0,1].
struct DeCasteljauPoints {
  std::array<glm::dvec3, 3> first;   // on the legs of the control polygon
  std::array<glm::dvec3, 2> second;  // on the lines between those: the tangent line
  glm::dvec3 point;                  // on the curve
};
DeCasteljauPoints construction(const Cubic& cubic, double t);

}  // namespace coaster::curve
