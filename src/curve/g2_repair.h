// The problem that solve_g2() solves, as a nonlinear programme: unknowns, objective and conditions. Private to g2*.cpp.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "curve/g2.h"

namespace coaster::curve::detail {

using glm::dvec3;

// Unknowns: the joint's two handles q and r, the joint's position on their line p = q + l (r - q), and the lengths of
// the far handles. In these unknowns every condition is a polynomial.
constexpr int kUnknowns = 9, kMostConditions = 11;
enum : int { kQ = 0, kR = 3, kL = 6, kA = 7, kB = 8 };
using Vector = std::array<double, kUnknowns>;
using Matrix = std::array<Vector, kUnknowns>;

struct G2Unknowns {
  dvec3 q, r;
  double l, a, b;
  dvec3 p() const { return q + l * (r - q); }
};

// Two unit vectors perpendicular to a unit direction and to each other.
struct Axes {
  dvec3 first, second;
};
Axes axes_across(dvec3 direction);

// Values c and rows of their derivatives, all in metres.
struct Conditions {
  int count = 0;
  std::array<double, kMostConditions> c{};
  std::array<Vector, kMostConditions> rows{};
  Vector& add(double value) {
    c[count] = value;
    rows[count] = {};
    return rows[count++];
  }
};

class G2Solver {
 public:
  explicit G2Solver(const G2Problem& problem) : problem_(problem) {
    // Coordinates relative to the joint, so that problems far from the origin lose no digits.
    const dvec3 origin = problem.position;
    problem_.in_handle -= origin;
    problem_.out_handle -= origin;
    problem_.position = dvec3(0);
    problem_.before.anchor -= origin;
    problem_.after.anchor -= origin;
    const dvec3 line = problem_.out_handle - problem_.in_handle;
    scale_ = glm::length(line);
    start_ = {problem_.in_handle, problem_.out_handle, glm::length(problem_.in_handle) / std::max(scale_, 1e-300),
              problem.before.length, problem.after.length};
    if (problem.equal_lengths) start_.l = 0.5;
  }

  G2Solution solve() const;
  double cost(const G2Unknowns& x) const {
    const dvec3 q = x.q - problem_.in_handle, r = x.r - problem_.out_handle, p = x.p();
    const double a = x.a - problem_.before.length, b = x.b - problem_.after.length;
    return 0.5 * (glm::dot(q, q) + glm::dot(r, r) + glm::dot(p, p) + a * a + b * b);
  }
  void slopes(const G2Unknowns& x, Vector& gradient, Matrix& hessian) const;
  Conditions conditions(const G2Unknowns& x, const Axes& across) const;
  void add_equal_curvature(const G2Unknowns& x, const Axes& axes, Conditions& to) const;
  void add_kept(const G2Side& side, const G2Unknowns& x, int handle, int length, Conditions& to) const;
  bool frozen(int unknown) const {
    return (unknown == kL && problem_.equal_lengths) || (unknown == kA && problem_.before.length_fixed) ||
           (unknown == kB && problem_.after.length_fixed);
  }
  static double size_of(const Conditions& now) {
    double sum = 0;
    for (int i = 0; i < now.count; ++i) sum += now.c[i] * now.c[i];
    return std::sqrt(sum);
  }
  struct Step {
    Vector d{};
    std::array<double, kMostConditions> multipliers{};
    bool finite = false;
  };
  Step step(const Conditions& now, const Vector& gradient, const Matrix& hessian) const;
  void bend(const G2Unknowns& x, const Axes& across, const std::array<double, kMostConditions>& multipliers,
            Matrix& hessian) const;
  double longest(const G2Unknowns& x, const Vector& d) const;

 private:
  G2Problem problem_;
  G2Unknowns start_{};
  double scale_ = 0;  // m, distance of the handles: scales the curvature condition to metres
};

}  // namespace coaster::curve::detail
