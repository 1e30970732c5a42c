#include "sim/shape/shape_distance.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "curve/polynomial_roots.h"

namespace coaster::sim {
namespace {

double square_distance(const glm::dvec3& p, const glm::dvec3& a, const glm::dvec3& b) {
  const glm::dvec3 ab = b - a, ap = p - a;
  const double square = glm::dot(ab, ab), t = square > 0 ? std::clamp(glm::dot(ap, ab) / square, 0.0, 1.0) : 0.0;
  const glm::dvec3 apart = ap - t * ab;
  return glm::dot(apart, apart);
}

// Returns the squared largest distance of the points of `from` to the polygon `to`. Consecutive points are close, so
// the search starts where the last one ended, and stops once it finds anything nearer than the largest distance so far:
// that point cannot raise it.
double directed(const std::vector<glm::dvec3>& from, const std::vector<glm::dvec3>& to) {
  const std::size_t spans = std::max<std::size_t>(1, to.size() - 1);
  double largest = 0;
  std::size_t start = 0;
  for (const glm::dvec3& p : from) {
    double nearest = std::numeric_limits<double>::infinity();
    std::size_t where = start;
    for (std::size_t i = 0; i < spans && nearest > largest; ++i) {
      const std::size_t span = (start + i) % spans;
      const double d = square_distance(p, to[span], to[std::min(span + 1, to.size() - 1)]);
      if (d < nearest) nearest = d, where = span;
    }
    start = where;
    largest = std::max(largest, nearest);
  }
  return largest;
}

}  // namespace

ShapeTrace trace_of(const world::Document& document) {
  ShapeTrace trace;
  const std::size_t segments = document.track.segments.size();
  if (segments == 0) {
    for (const world::Entity e : document.track.knots) trace.points.emplace_back(world::knot(document, e).position);
    return trace;
  }
  const std::size_t steps = std::max<std::size_t>(segments > kTracePoints ? 1 : 8, kTracePoints / segments);
  for (const world::Entity e : document.track.segments) {
    const curve::Cubic cubic = world::cubic_of(document, e);
    if (trace.points.empty()) trace.points.emplace_back(cubic.p0);
    for (std::size_t i = 1; i <= steps; ++i)
      trace.points.push_back(curve::point(cubic, static_cast<double>(i) / static_cast<double>(steps)));
  }
  return trace;
}

double shape_distance(const ShapeTrace& a, const ShapeTrace& b) {
  if (a.points.empty() || b.points.empty())
    return a.points.empty() == b.points.empty() ? 0.0 : std::numeric_limits<double>::infinity();
  return std::sqrt(std::max(directed(a.points, b.points), directed(b.points, a.points)));
}

// --- The errors of a polyline: rounding, and the distance of its chords from the curve

using glm::dvec3;

// Vertices for which the point in double proves a smaller deviation than the largest so far need no exact point.
double deviation_of(const curve::Cubic& cubic, std::span<const glm::vec3> points) {
  const curve::CoefficientsD rounded = curve::coefficients_d(cubic);
  float largest = 1;
  for (const glm::vec3 p : {cubic.p0, cubic.p1, cubic.p2, cubic.p3})
    largest = std::max({largest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  const double rounding = 1e-12 * double{largest};  // m, of a point in double: at least ten times its possible error
  const double last = static_cast<double>(points.size()) - 1;
  double worst = 0, enough = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const dvec3 vertex(points[i]);
    const double t = static_cast<double>(i) / last;
    const dvec3 near = vertex - rounded.point(t);
    if (glm::dot(near, near) < enough) continue;
    const dvec3 d = vertex - curve::point_long_double(cubic, t);
    worst = std::max(worst, glm::dot(d, d));
    const double nearest = std::max(0.0, std::sqrt(worst) - rounding);
    enough = nearest * nearest;
  }
  return std::sqrt(worst);
}

namespace {

// The curve between two vertices, B(a + h u) - B(a) = q1 u + q2 u^2 + q3 u^3 with u in [0,1], and its chord.
struct ChordPiece {
  dvec3 q1, q2, q3, chord = q1 + q2 + q3;
  double square = glm::dot(chord, chord);

  // Returns the squared distance (m^2) of the point at u from the chord, a segment.
  double off(double u) const {
    const dvec3 away = (u * u - u) * (q2 + (1 + u) * q3);  // from the chord's point at u
    const double foot = square > 0 ? std::clamp(u + glm::dot(away, chord) / square, 0.0, 1.0) : u;
    const dvec3 d = away - (foot - u) * chord;
    return glm::dot(d, d);
  }
  dvec3 across(dvec3 v) const { return square > 0 ? v - glm::dot(v, chord) / square * chord : v; }
};

// Returns the curve x + y t + z t^2 in Bernstein form.
std::array<dvec3, 3> quadratic(dvec3 x, dvec3 y, dvec3 z) { return {x, x + 0.5 * y, x + y + z}; }

// Returns the largest squared distance. From the chord's line it is u (1-u) |e + u f|, with e and f perpendicular to
// the chord: its extrema are at the roots of a cubic. Where a foot is beyond an end of the chord, those of the distance
// from there count: (B - B(a)) . B' has the root u = 0, which leaves a quartic.
double largest_off(const ChordPiece& p) {
  double worst = 0;
  const auto look = [&](double u) { worst = std::max(worst, p.off(u)); };
  const dvec3 e = p.across(p.q2 + p.q3), f = p.across(p.q3);
  const double ee = glm::dot(e, e), ef = glm::dot(e, f), ff = glm::dot(f, f);
  curve::each_root(std::array{ee, ee / 3 + ef, (ef + 2 * ff - ee) / 3, -(ee + 2 * ef + ff)}, look);
  const auto from_end = [](dvec3 a, dvec3 b, dvec3 c, const auto& found) {
    curve::each_root(curve::product(quadratic(a, b, c), quadratic(a, 2.0 * b, 3.0 * c)), found);
  };
  from_end(p.q1, p.q2, p.q3, look);
  from_end(-(p.q1 + 2.0 * p.q2 + 3.0 * p.q3), p.q2 + 3.0 * p.q3, -p.q3, [&](double u) { look(1 - u); });
  return worst;
}

// What bounds the error of the pieces about m = a + h/2 of an interval of m: quartics in m, in Bernstein form. The
// chord is h V, V = B' + h^2 c3 / 4. By Cauchy and Schwarz u^2 (1-u)^2 |e + u f|^2 <= (|e|^2 + |e + f|^2) / 32.
struct ChordBounds {
  std::array<double, 5> speed;   // |V|^2
  std::array<double, 5> across;  // error^2 = h^4 across / (16 speed) at most, from the chord's line
  std::array<double, 5> second;  // |B''|^2 + h^2 |c3|^2: error^2 = h^4 second / 64 at most, also from the segment

  // Returns false only if no piece's error is above the root of `square`. Every foot is within its chord where B' stays
  // within |V| of V.
  bool may_exceed(double square, double h2) const {
    bool less = true, flat = true;
    const double scaled = square / (h2 * h2);
    for (std::size_t k = 0; k < 5; ++k) {
      less = less && across[k] <= 16 * scaled * speed[k] && 0.5 * h2 * second[k] <= speed[k];
      flat = flat && second[k] <= 64 * scaled;
    }
    return !less && !flat;
  }
};

ChordBounds bounds_of(const curve::CoefficientsD& c, double h) {
  const dvec3 x12 = glm::cross(c.c1, c.c2), x13 = glm::cross(c.c1, c.c3), x23 = glm::cross(c.c2, c.c3);
  const auto square = [](const std::array<dvec3, 3>& v) { return curve::product(v, v); };
  ChordBounds b{square(quadratic(c.c1 + 0.25 * h * h * c.c3, 2.0 * c.c2, 3.0 * c.c3)),
                square(quadratic(x12 - 0.25 * h * h * x23, 3.0 * x13, 3.0 * x23)),
                square(quadratic(2.0 * c.c2, 6.0 * c.c3, dvec3(0)))};
  const auto turn = square(quadratic(0.5 * h * x13, h * x23, dvec3(0)));
  for (std::size_t k = 0; k < 5; ++k) b.across[k] += turn[k], b.second[k] += h * h * glm::dot(c.c3, c.c3);
  return b;
}

// Searches the pieces whose middles are in [low, high), the worse half first.
struct ChordSearch {
  const curve::CoefficientsD& c;
  int steps;
  double enough;  // m^2: pieces that cannot exceed it need no look
  double h = 1.0 / steps, worst = 0;

  void run(double low, double high, const ChordBounds& bounds) {
    const double first = std::ceil(low * steps - 0.5), last = std::ceil(high * steps - 0.5);
    if (first >= last || !bounds.may_exceed(enough, h * h)) return;
    if (last - first == 1) {
      const double a = first * h;
      worst = std::max(worst, largest_off({h * c.derivative(a), h * h * (c.c2 + 3 * a * c.c3), h * h * h * c.c3}));
      enough = std::max(enough, worst * (1 + 2e-9));
      return;
    }
    ChordBounds left, right;
    curve::halve(bounds.speed, left.speed, right.speed);
    curve::halve(bounds.across, left.across, right.across);
    curve::halve(bounds.second, left.second, right.second);
    const double middle = 0.5 * (low + high);
    const bool falls = left.across[2] * right.speed[2] > right.across[2] * left.speed[2];
    if (falls) run(low, middle, left);
    run(middle, high, right);
    if (!falls) run(low, middle, left);
  }
};

}  // namespace

double chord_error(const curve::Cubic& cubic, int steps, double known) {
  const curve::CoefficientsD c = curve::coefficients_d(cubic);
  const double h = 1.0 / steps;
  const double least = 1e-15 * h * h * (glm::length(c.c1) + glm::length(c.c2) + glm::length(c.c3));  // m, rounding
  ChordSearch search{c, steps, std::max(known * known, least * least)};
  search.run(0, 1, bounds_of(c, h));
  return std::max(known, std::sqrt(search.worst));
}

double chord_error(const DerivedTrack& derived) {
  double worst = 0;
  for (const world::Entity segment : derived.order)
    worst = chord_error(derived.shape(segment).key.cubic, derived.steps, worst);
  return worst;
}

}  // namespace coaster::sim
