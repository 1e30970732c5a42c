#include "curve/evaluators.h"

#include <array>

#include "base/check.h"
#include "curve/evaluators_detail.h"
#include "curve/kernels.h"

namespace coaster::curve {
namespace {

using Points = std::span<glm::vec3>;

// Joints never gap: both ends are the control points themselves, whatever the arithmetic gave.
void pin_ends(const Cubic& cubic, Points points) {
  points.front() = cubic.p0;
  points.back() = cubic.p3;
}

int steps_of(Points points, Points tangents) {
  COASTER_CHECK(points.size() >= 2, "a polyline has at least one step");
  COASTER_CHECK(tangents.empty() || tangents.size() == points.size(), "as many tangents as points, or none");
  return static_cast<int>(points.size()) - 1;
}

// Writes point(t) and tangent(t) at t = i/n.
template <class G2Unknowns, class Tangent>
void write(const Cubic& cubic, Points points, Points tangents, G2Unknowns point, Tangent tangent) {
  const int n = steps_of(points, tangents);
  for (int i = 0; i <= n; ++i) points[i] = point(static_cast<float>(i) / static_cast<float>(n));
  if (!tangents.empty())
    for (int i = 0; i <= n; ++i) tangents[i] = tangent(static_cast<float>(i) / static_cast<float>(n));
  pin_ends(cubic, points);
}

void bernstein(const PreparedCubic& curve, Points points, Points tangents) {
  const auto point = [&c = curve.cubic](float t) { return detail::bernstein(c.p0, c.p1, c.p2, c.p3, t); };
  const auto tangent = [&c = curve.cubic](float t) {
    const float s = 1.0f - t;
    return 3.0f * s * s * (c.p1 - c.p0) + 6.0f * t * s * (c.p2 - c.p1) + 3.0f * t * t * (c.p3 - c.p2);
  };
  write(curve.cubic, points, tangents, point, tangent);
}

void de_casteljau(const PreparedCubic& curve, Points points, Points tangents) {
  const auto point = [&c = curve.cubic](float t) { return detail::de_casteljau(c.p0, c.p1, c.p2, c.p3, t); };
  const auto tangent = [&c = curve.cubic](float t) {
    const auto [left, right] = detail::tangent_line(c.p0, c.p1, c.p2, c.p3, t);
    return 3.0f * (right - left);
  };
  write(curve.cubic, points, tangents, point, tangent);
}

void horner(const PreparedCubic& curve, Points points, Points tangents) {
  const Coefficients& c = curve.monomial;
  const glm::vec3 d1 = 2.0f * c.c2, d2 = 3.0f * c.c3;
  write(
      curve.cubic, points, tangents, [&](float t) { return detail::horner(c.c0, c.c1, c.c2, c.c3, t); },
      [&](float t) { return c.c1 + t * (d1 + t * d2); });
}

void estrin(const PreparedCubic& curve, Points points, Points tangents) {
  const Coefficients& c = curve.monomial;
  const glm::vec3 d1 = 2.0f * c.c2, d2 = 3.0f * c.c3;
  write(
      curve.cubic, points, tangents, [&](float t) { return detail::estrin(c.c0, c.c1, c.c2, c.c3, t); },
      [&](float t) { return (c.c1 + t * d1) + (t * t) * d2; });
}

void forward_differences(const PreparedCubic& curve, Points points, Points tangents) {
  const Coefficients& c = curve.monomial;
  const int n = steps_of(points, tangents);
  const float e = 1.0f / static_cast<float>(n);
  auto d = detail::start_differences(c.c0, c.c1, c.c2, c.c3, e);
  for (int i = 0; i <= n; ++i, detail::step(d)) points[i] = d.value;
  if (!tangents.empty()) {
    auto g = detail::start_tangent_differences(c.c1, c.c2, c.c3, e);
    for (int i = 0; i <= n; ++i, detail::step(g)) tangents[i] = g.value;
  }
  pin_ends(curve.cubic, points);
}

// By the vector kernels. Tangents are the points of the derivative, a cubic whose last coefficient is 0 and whose p3 is
// B'(1).
template <VectorMethod Method>
void by_eights(const PreparedCubic& curve, Points points, Points tangents) {
  steps_of(points, tangents);
  vector_polyline(Method, curve, points);
  points.front() = curve.cubic.p0;
  if (tangents.empty()) return;
  const Coefficients& c = curve.monomial;
  PreparedCubic slope;
  slope.cubic.p3 = 3.0f * (curve.cubic.p3 - curve.cubic.p2);
  slope.monomial = {c.c1, 2.0f * c.c2, 3.0f * c.c3, glm::vec3(0)};
  vector_polyline(Method, slope, tangents);
}

// Error bounds. u = 2^-24 is float's unit roundoff; M = extent bounds the coordinates' size (as a vector length), S =
// size the polygon's length. Norms of vectors: rounding each of three components by u relative gives at most u times
// the vector's length.
constexpr double kU = 1.0 / (1 << 24);

// Bernstein: t = i/n is off by u and 1-t by u more, so each weight w is off by at most 6 u w (three factors, two or
// three products), its product with p by u more, and three additions of partial sums below M add 3 u M. Since the
// weights sum to 1, 10 u M covers the arithmetic; the error of t moves the point by |B'| u t <= 3 S u.
double bernstein_bound(double extent, double size, int) { return kU * (11.0 * extent + 4.0 * size); }

// De Casteljau: three rounds of affine combinations of points below M; 1-t, two products and an addition cost 3.5 u M a
// round, rounds do not amplify; t as above.
double casteljau_bound(double extent, double size, int) { return kU * (11.0 * extent + 4.0 * size); }

// Horner: the additions of c1..c3 work on differences: |d_i| <= S, |c1| <= 3S, |c2| <= 6S, |c3| <= 4S, so values stay
// below 13 S and each of five operations costs u times that, coefficients 4 u each; only the last addition sees c0 = p0
// and rounds at M. A difference of control points itself rounds at its own size.
double horner_bound(double extent, double size, int) { return kU * (extent + 120.0 * size); }

// Estrin: c0 + t c1 rounds below M + 3 S and the last addition at M; the rest as Horner's, with t^2 off by 2 u.
double estrin_bound(double extent, double size, int) { return kU * (2.0 * extent + 130.0 * size); }

// Forward differences: step k rounds `value` by u M and `first` by u |first| with |first| <= 6 S/n: after n steps n u M
// from the value's own sums, and from the errors of first (e1 a step), second (e2) and third (e3, at the start alone):
// sum_k k e1 + k^2/2 e2 + k^3/6 e3 with e1 <= 6 u S/n, e2 <= 24 u S/n^2 (rounding of each addition), and relative
// errors of about 10 u in the starting differences, which grow to 10 u S (3 + 6 + 4).
double forward_differences_bound(double extent, double size, int steps) {
  const double n = steps;
  return kU * (extent * (n + 1.0) + size * (3.0 * n + 6.0) + size * (3.0 * n + 12.0) + 140.0 * size);
}

// The vector rows keep their bounds for any number of steps, as each vertex or each run of 64 starts anew.
double horner8_bound(double extent, double size, int) { return vector_horner_error_bound(extent, size); }
double forward_differences8_bound(double extent, double size, int) {
  return vector_differences_error_bound(extent, size);
}

constexpr std::array<Evaluator, 10> kEvaluators{{
    {"bernstein", "Cubic (Bernstein)", "(1-t)^3 p0 + 3t(1-t)^2 p1 + 3t^2(1-t) p2 + t^3 p3",
     "3 vector additions, 4 vector and 10 scalar multiplications", bernstein, bernstein_bound},
    {"de_casteljau", "de Casteljau", "b_i <- (1-t) b_i + t b_(i+1), three rounds", "6 linear interpolations",
     de_casteljau, casteljau_bound},
    {"horner", "Horner", "c0 + t (c1 + t (c2 + t c3)), coefficients stored",
     "3 vector additions, 3 vector multiplications", horner, horner_bound},
    {"forward_differences", "Forward differences", "f += d1, d1 += d2, d2 += d3", "3 vector additions",
     forward_differences, forward_differences_bound},
    {"estrin", "Estrin", "(c0 + t c1) + t^2 (c2 + t c3), coefficients stored",
     "3 vector additions, 3 vector and 1 scalar multiplications", estrin, estrin_bound},
    {"horner8", "Horner, 8 at once", "Horner's rule for eight parameters in one vector",
     "3 vector additions, 3 vector multiplications, by eights", by_eights<VectorMethod::horner>, horner8_bound},
    {"forward_differences8", "Forward differences, 8 lanes", "each lane steps by 8/n, restarted every 64 points",
     "4 vector additions, by eights", by_eights<VectorMethod::differences>, forward_differences8_bound},
    {"gpu_vertex", "Vertex shader", "Horner at t = gl_VertexID / n, coefficients from the control points",
     "9 vector additions, 5 vector multiplications", horner, horner_bound, EvaluatedBy::vertex_shader},
    {"gpu_geometry", "Geometry shader", "Horner at t = i / n, one point becomes a strip",
     "9 vector additions, 5 vector multiplications", horner, horner_bound, EvaluatedBy::geometry_shader},
    {"gpu_tessellation", "Tessellation shader", "Horner at gl_TessCoord.x of a patch of four control points",
     "9 vector additions, 5 vector multiplications", horner, horner_bound, EvaluatedBy::tessellation_shader},
}};

}  // namespace

std::span<const Evaluator> evaluators() { return kEvaluators; }

}  // namespace coaster::curve
