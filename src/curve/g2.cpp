// The solver: sequential quadratic programming, by Newton steps if they decrease the merit, else by Gauss-Newton steps.
// The problem is in g2_repair.h;
// its objective and conditions have first derivatives, and the objective second ones.
#include "curve/g2.h"

#include <numeric>

#include "base/numerics.h"
#include "curve/g2_repair.h"

namespace coaster::curve {
namespace detail {
namespace {

void put(Vector& row, int at, dvec3 v) {
  for (int i = 0; i < 3; ++i) row[at + i] = v[i];
}

}  // namespace

Axes axes_across(dvec3 direction) {
  const dvec3 a = glm::abs(direction);
  const dvec3 axis = a.x <= a.y && a.x <= a.z ? dvec3(1, 0, 0) : a.y <= a.z ? dvec3(0, 1, 0) : dvec3(0, 0, 1);
  const dvec3 first = glm::normalize(glm::cross(direction, axis));
  return {first, glm::normalize(glm::cross(direction, first))};
}

void G2Solver::slopes(const G2Unknowns& x, Vector& gradient, Matrix& hessian) const {
  const dvec3 p = x.p(), line = x.r - x.q;
  const double u = 1.0 - x.l;
  gradient = {};
  hessian = {};
  put(gradient, kQ, x.q - problem_.in_handle + u * p);
  put(gradient, kR, x.r - problem_.out_handle + x.l * p);
  gradient[kL] = glm::dot(line, p);
  gradient[kA] = x.a - problem_.before.length;
  gradient[kB] = x.b - problem_.after.length;
  // Gauss-Newton: J^T J of the movements, positive definite while the handles are apart.
  for (int i = 0; i < 3; ++i) {
    hessian[kQ + i][kQ + i] = 1.0 + u * u;
    hessian[kR + i][kR + i] = 1.0 + x.l * x.l;
    hessian[kQ + i][kR + i] = hessian[kR + i][kQ + i] = u * x.l;
    hessian[kQ + i][kL] = hessian[kL][kQ + i] = u * line[i];
    hessian[kR + i][kL] = hessian[kL][kR + i] = x.l * line[i];
  }
  hessian[kL][kL] = glm::dot(line, line);
  hessian[kA][kA] = hessian[kB][kB] = 1.0;
}

void G2Solver::add_equal_curvature(const G2Unknowns& x, const Axes& axes, Conditions& to) const {
  const dvec3 line = x.r - x.q, p = x.p();
  const dvec3 a = problem_.before.anchor + x.a * problem_.before.direction - p,
              b = problem_.after.anchor + x.b * problem_.after.direction - p;
  const double u = 1.0 - x.l, skew = 1.0 - 2.0 * x.l;
  // out^2 (a - p) - in^2 (b - p), over the square of the handles' distance, must be parallel to the line of the
  // handles.
  const dvec3 v = u * u * a - x.l * x.l * b;
  const dvec3 dv_dl = -2.0 * u * a - 2.0 * x.l * b - skew * line;
  const dvec3 across = glm::cross(line, v) / scale_;
  for (const dvec3 e : {axes.first, axes.second}) {
    const dvec3 by_v = glm::cross(e, line) / scale_, by_line = glm::cross(v, e) / scale_;
    Vector& row = to.add(glm::dot(e, across));
    put(row, kQ, -by_line - skew * u * by_v);
    put(row, kR, by_line - skew * x.l * by_v);
    row[kL] = glm::dot(by_v, dv_dl);
    row[kA] = u * u * glm::dot(by_v, problem_.before.direction);
    row[kB] = -x.l * x.l * glm::dot(by_v, problem_.after.direction);
  }
}

void G2Solver::add_kept(const G2Side& side, const G2Unknowns& x, int handle, int length, Conditions& to) const {
  const dvec3 at = handle == kQ ? x.q : x.r, was = handle == kQ ? problem_.in_handle : problem_.out_handle;
  const double size = handle == kQ ? x.a : x.b;
  switch (side.keep) {
    case G2Side::FarEndConstraint::nothing: return;
    case G2Side::FarEndConstraint::handle:
      for (int i = 0; i < 3; ++i) to.add(at[i] - was[i])[handle + i] = 1.0;
      return;
    case G2Side::FarEndConstraint::curvature: {
      // k = (2/3) (part of (handle - anchor) across the direction) / length^2
      const Axes axes = axes_across(side.direction);
      for (const dvec3 e : {axes.first, axes.second}) {
        Vector& row = to.add(glm::dot(e, at - side.anchor) - 1.5 * size * size * glm::dot(e, side.curvature));
        put(row, handle, e);
        row[length] = -3.0 * size * glm::dot(e, side.curvature);
      }
    }
  }
}

Conditions G2Solver::conditions(const G2Unknowns& x, const Axes& across) const {
  Conditions all;
  add_equal_curvature(x, across, all);
  add_kept(problem_.before, x, kQ, kA, all);
  add_kept(problem_.after, x, kR, kB, all);
  if (problem_.position_fixed) {
    const dvec3 p = x.p(), line = x.r - x.q;
    for (int i = 0; i < 3; ++i) {
      Vector& row = all.add(p[i]);
      row[kQ + i] = 1.0 - x.l;
      row[kR + i] = x.l;
      row[kL] = line[i];
    }
  }
  return all;
}

namespace {

G2Unknowns moved(G2Unknowns x, const Vector& d, double step) {
  for (int i = 0; i < 3; ++i) x.q[i] += step * d[kQ + i], x.r[i] += step * d[kR + i];
  x.l += step * d[kL];
  x.a += step * d[kA];
  x.b += step * d[kB];
  return x;
}

template <std::size_t N>
double dot(const std::array<double, N>& a, const std::array<double, N>& b) {
  return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
}

}  // namespace

// Solves one quadratic programme: [H C^T; C -e] [d; m] = [-g; -c] by Gaussian elimination with row exchanges. The small
// e keeps the system regular where conditions are redundant; contradictory conditions leave a violation that does not
// decrease.
G2Solver::Step G2Solver::step(const Conditions& now, const Vector& gradient, const Matrix& hessian) const {
  constexpr int kMost = kUnknowns + kMostConditions;
  std::array<std::array<double, kMost>, kMost> m{};
  std::array<double, kMost> x{};
  const int n = kUnknowns + now.count;
  for (int i = 0; i < kUnknowns; ++i) {
    if (frozen(i)) {
      m[i][i] = 1.0;
      continue;
    }
    for (int j = 0; j < kUnknowns; ++j) m[i][j] = frozen(j) ? 0.0 : hessian[i][j];
    x[i] = -gradient[i];
    for (int k = 0; k < now.count; ++k) m[i][kUnknowns + k] = m[kUnknowns + k][i] = now.rows[k][i];
  }
  for (int k = 0; k < now.count; ++k) {
    m[kUnknowns + k][kUnknowns + k] = -1e-13;
    x[kUnknowns + k] = -now.c[k];
  }
  if (!base::solve_linear(m, x, static_cast<std::size_t>(n), 0.0)) return {};
  Step out;
  out.finite = true;
  for (int i = 0; i < n; ++i) {
    if (!std::isfinite(x[i])) return {};
    (i < kUnknowns ? out.d[i] : out.multipliers[i - kUnknowns]) = x[i];
  }
  return out;
}

// Adds the terms that Gauss-Newton leaves out: the second derivatives of the movements and, times the multipliers, of
// the conditions. All are polynomials, so central differences of the exact slopes are good to 1e-8.
void G2Solver::bend(const G2Unknowns& x, const Axes& across, const std::array<double, kMostConditions>& multipliers,
                    Matrix& hessian) const {
  for (int j = 0; j < kUnknowns; ++j) {
    if (frozen(j)) continue;
    const double h = 1e-4 * (j == kL ? 1.0 : scale_);
    Vector unit{};
    unit[j] = 1.0;
    const Conditions more = conditions(moved(x, unit, h), across), less = conditions(moved(x, unit, -h), across);
    for (int k = 0; k < more.count; ++k)
      for (int i = 0; i < kUnknowns; ++i)
        hessian[i][j] += multipliers[k] * (more.rows[k][i] - less.rows[k][i]) / (2.0 * h);
  }
  // The second derivatives of p = q + l (r - q) involve only l: d2p/dq dl = -1, d2p/dr dl = 1.
  const dvec3 p = x.p();
  for (int i = 0; i < 3; ++i) {
    hessian[kQ + i][kL] -= p[i], hessian[kL][kQ + i] -= p[i];
    hessian[kR + i][kL] += p[i], hessian[kL][kR + i] += p[i];
  }
}

// Returns the longest part of a step that keeps handles from reversing: lengths fall to a quarter at most, and so does
// the fraction of each side.
double G2Solver::longest(const G2Unknowns& x, const Vector& d) const {
  double part = 1.0;
  const auto keep = [&](double value, double change) {
    if (change < 0.0 && value + part * change < 0.25 * value) part = -0.75 * value / change;
  };
  keep(x.l, d[kL]);
  keep(1.0 - x.l, -d[kL]);
  keep(x.a, d[kA]);
  keep(x.b, d[kB]);
  return part;
}

G2Solution G2Solver::solve() const {
  constexpr int kMostIterations = 60, kMostHalvings = 24;
  constexpr double kLeast = 1.0 / 16;  // of the original length: shorter handles are no repair, and curvature, divided
                                       // by their square, loses its digits
  G2Solution out;
  G2Unknowns x = start_;
  Vector gradient{};
  Matrix hessian{};
  double penalty = 1.0;
  out.outcome = G2Outcome::no_convergence;
  for (out.iterations = 1; out.iterations <= kMostIterations; ++out.iterations) {
    const dvec3 line = x.r - x.q;
    const Axes across = axes_across(line / glm::length(line));
    const Conditions now = conditions(x, across);
    slopes(x, gradient, hessian);
    Step s = step(now, gradient, hessian);
    if (!s.finite) break;
    // A Newton step if it decreases the merit and the curvature is positive; else a Gauss-Newton step.
    Matrix bent = hessian;
    bend(x, across, s.multipliers, bent);
    const Step newton = step(now, gradient, bent);
    double curved = 0;
    for (int i = 0; i < kUnknowns; ++i)
      for (int j = 0; j < kUnknowns; ++j) curved += newton.d[i] * bent[i][j] * newton.d[j];
    if (newton.finite && curved > 1e-3 * dot(newton.d, newton.d)) s = newton;
    penalty = std::max(penalty, 2.0 * std::sqrt(dot(s.multipliers, s.multipliers)));
    const double descent = dot(gradient, s.d), before = size_of(now), length = std::sqrt(dot(s.d, s.d));
    if (length < 1e-9 * scale_ && before < 1e-8 * scale_) {
      out.outcome = G2Outcome::solved;
      break;
    }
    // Movement and violation together must decrease (an exact penalty). Near the solution rounding hides that, and the
    // step is tiny.
    const double merit = cost(x) + penalty * before;
    double part = longest(x, s.d);
    for (int halving = 0; halving < kMostHalvings; ++halving, part *= 0.5) {
      const G2Unknowns next = moved(x, s.d, part);
      if (cost(next) + penalty * size_of(conditions(next, across)) <=
          merit + 1e-4 * part * (descent - penalty * before) + 1e-13 * merit)
        break;
    }
    x = moved(x, s.d, part);
    // The step shrinks to zero, or the joint runs away: there is no solution nearby.
    const bool collapsed = glm::length(x.r - x.q) < kLeast * scale_ || x.l < 0.25 * kLeast ||
                           x.l > 1.0 - 0.25 * kLeast || x.a < kLeast * problem_.before.length ||
                           x.b < kLeast * problem_.after.length;
    if (part < 1e-12 || collapsed || !(cost(x) < 1e4 * scale_ * scale_)) break;
  }
  out.in_handle = x.q;
  out.position = x.p();
  out.out_handle = x.r;
  out.before_length = x.a;
  out.after_length = x.b;
  out.movement = std::sqrt(2.0 * cost(x));
  return out;
}

}  // namespace detail

namespace {

bool usable(const G2Problem& p) {
  const auto finite = [](glm::dvec3 v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); };
  for (const glm::dvec3 v : {p.in_handle, p.position, p.out_handle, p.before.anchor, p.before.direction,
                             p.before.curvature, p.after.anchor, p.after.direction, p.after.curvature})
    if (!finite(v)) return false;
  return glm::length(p.position - p.in_handle) > 0 && glm::length(p.out_handle - p.position) > 0 &&
         p.before.length > 0 && p.after.length > 0;
}

}  // namespace

G2Solution solve_g2(const G2Problem& problem) {
  if (!usable(problem)) return {};
  G2Solution solution = detail::G2Solver(problem).solve();
  solution.in_handle += problem.position;
  solution.position += problem.position;
  solution.out_handle += problem.position;
  return solution;
}

}  // namespace coaster::curve
