// The objective and the conditions of a repair with first derivatives, and the second derivatives of the objective.
#include "curve/g2_repair.h"

namespace coaster::curve::detail {
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

void Repair::slopes(const Point& x, Vector& gradient, Matrix& hessian) const {
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

void Repair::add_equal_curvature(const Point& x, const Axes& axes, Conditions& to) const {
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

void Repair::add_kept(const G2Side& side, const Point& x, int handle, int length, Conditions& to) const {
  const dvec3 at = handle == kQ ? x.q : x.r, was = handle == kQ ? problem_.in_handle : problem_.out_handle;
  const double size = handle == kQ ? x.a : x.b;
  switch (side.keep) {
    case G2Side::Keep::nothing: return;
    case G2Side::Keep::handle:
      for (int i = 0; i < 3; ++i) to.add(at[i] - was[i])[handle + i] = 1.0;
      return;
    case G2Side::Keep::curvature: {
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

Conditions Repair::conditions(const Point& x, const Axes& across) const {
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

}  // namespace coaster::curve::detail
