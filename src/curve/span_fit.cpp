#include "curve/span_fit.h"

#include <algorithm>
#include <cmath>

#include "base/check.h"
#include "curve/frames.h"

namespace coaster::curve {
namespace {

using glm::dmat2;
using glm::dvec2;
using glm::dvec3;

// Returns the unit direction in which a span bends at one of its ends; 0 if it is straight. `other` is the tangent at
// its far end.
dvec3 bend_direction(const PathPoint& p, dvec3 other, double length) {
  constexpr double kFelt = 1e-6;  // rad
  for (const dvec3 wish : {p.curvature * length, across(other, p.tangent)})
    if (const double size = glm::length(wish); size > kFelt) return wish / size;
  return dvec3(0);
}

// The terms of the jump of the curvature vector at an inner knot: (2/3) |part of the second leg of the control polygon
// perpendicular to the tangent| / handle^2 on both sides.
struct JumpTerms {
  dvec3 after, before;  // m, from the knot to the far handle
  double out_square, in_square;
  dvec3 jump;  // 1/m
};
JumpTerms jump_at(const SpanKnots& n, std::size_t k) {
  JumpTerms j{n.place[k + 1] - n.in[k + 1] * n.tangent[k + 1] - n.place[k],
              n.place[k - 1] + n.out[k - 1] * n.tangent[k - 1] - n.place[k], n.out[k] * n.out[k], n.in[k] * n.in[k],
              dvec3(0)};
  j.jump = 2.0 / 3.0 * across(j.after / j.out_square - j.before / j.in_square, n.tangent[k]);
  return j;
}

struct Basis {
  dvec3 u, v;
};
Basis basis_at(dvec3 tangent) {
  const dvec3 u = perpendicular(tangent, {0, 1, 0});
  return {u, glm::cross(tangent, u)};
}

// Returns the 2 x 2 block of the effect of turning a tangent on a jump: columns for turning along `of`, rows along
// `on`.
dmat2 block(double factor, const Basis& of, const Basis& on) {
  return dmat2(factor * dvec2(glm::dot(of.u, on.u), glm::dot(of.u, on.v)),
               factor * dvec2(glm::dot(of.v, on.u), glm::dot(of.v, on.v)));
}

}  // namespace

HandleLengths handle_lengths(const PathPoint& from, const PathPoint& to) {
  constexpr int kSteps = 16;
  constexpr double kHold = 1e-7;  // weak preference for a third of the length, negligible unless the span is straight
  const double length = to.s - from.s, third = length / 3.0;
  const dvec3 chord = to.position - from.position;
  const dvec3 first = bend_direction(from, to.tangent, length), second = bend_direction(to, from.tangent, length);
  const double k0 = glm::dot(from.curvature, first), k1 = glm::dot(to.curvature, second),
               turn0 = glm::dot(first, to.tangent), turn1 = glm::dot(second, from.tangent);
  double a = third, b = third;
  for (int i = 0; i < kSteps; ++i) {
    const double r0 = glm::dot(first, chord) - b * turn0 - 1.5 * a * a * k0,
                 r1 = a * turn1 - glm::dot(second, chord) - 1.5 * b * b * k1;
    const dvec2 da(-3.0 * a * k0, turn1), db(-turn0, -3.0 * b * k1);
    // Normal equations of the two residuals and of that preference.
    const double aa = glm::dot(da, da) + kHold * kHold, bb = glm::dot(db, db) + kHold * kHold, ab = glm::dot(da, db);
    const double ra = -(da.x * r0 + da.y * r1) - kHold * kHold * (a - third),
                 rb = -(db.x * r0 + db.y * r1) - kHold * kHold * (b - third);
    const double determinant = aa * bb - ab * ab;
    if (!(determinant > 0)) break;
    const double most = 0.25 * third;
    a = std::clamp(a + std::clamp((ra * bb - rb * ab) / determinant, -most, most), 0.2 * third, 3.0 * third);
    b = std::clamp(b + std::clamp((rb * aa - ra * ab) / determinant, -most, most), 0.2 * third, 3.0 * third);
  }
  return {a, b};
}

SpanKnots span_nodes(std::span<const PathPoint> points) {
  COASTER_CHECK(points.size() >= 2, "a span has two ends");
  SpanKnots n;
  n.out.assign(points.size(), 0), n.in.assign(points.size(), 0);
  for (std::size_t k = 0; k < points.size(); ++k) {
    n.place.push_back(points[k].position);
    n.tangent.push_back(points[k].tangent);
    if (k == 0) continue;
    const HandleLengths lengths = handle_lengths(points[k - 1], points[k]);
    n.out[k - 1] = lengths.out, n.in[k] = lengths.in;
  }
  return n;
}

double turn_tangents(SpanKnots& n) {
  constexpr double kMostTurn = 0.1;  // rad per step
  const std::size_t count = n.place.size();
  std::vector<Basis> basis(count);
  std::vector<dmat2> upper(count, dmat2(0.0));
  std::vector<dvec2> rest(count, dvec2(0));
  for (std::size_t k = 0; k < count; ++k) basis[k] = basis_at(n.tangent[k]);
  double largest = 0;
  for (std::size_t k = 1; k + 1 < count; ++k) {
    const JumpTerms j = jump_at(n, k);
    largest = std::max(largest, glm::length(j.jump));
    const double own =
        2.0 / 3.0 * (glm::dot(j.before, n.tangent[k]) / j.in_square - glm::dot(j.after, n.tangent[k]) / j.out_square);
    dmat2 diagonal = block(own, basis[k], basis[k]);
    dvec2 right(-glm::dot(j.jump, basis[k].u), -glm::dot(j.jump, basis[k].v));
    if (k > 1) {
      const dmat2 lower = block(-2.0 / 3.0 * n.out[k - 1] / j.in_square, basis[k - 1], basis[k]);
      diagonal -= lower * upper[k - 1], right -= lower * rest[k - 1];
    }
    const dmat2 inverse = glm::inverse(diagonal);
    if (k + 2 < count) upper[k] = inverse * block(-2.0 / 3.0 * n.in[k + 1] / j.out_square, basis[k + 1], basis[k]);
    rest[k] = inverse * right;
  }
  dvec2 turn(0);
  for (std::size_t k = count - 1; k-- > 1;) {
    turn = rest[k] - upper[k] * turn;
    const double size = glm::length(turn);
    if (!(size <= kMostTurn)) turn = size > 0 && std::isfinite(size) ? turn * (kMostTurn / size) : dvec2(0);
    n.tangent[k] = glm::normalize(n.tangent[k] + turn.x * basis[k].u + turn.y * basis[k].v);
  }
  return largest;
}

Cubic span_cubic(const SpanKnots& n, std::size_t k) {
  return {glm::vec3(n.place[k]), glm::vec3(n.place[k] + n.out[k] * n.tangent[k]),
          glm::vec3(n.place[k + 1] - n.in[k + 1] * n.tangent[k + 1]), glm::vec3(n.place[k + 1])};
}

}  // namespace coaster::curve
