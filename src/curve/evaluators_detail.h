// The inner loops of evaluators over any vector and scalar type, so that a test can count their operations.
#pragma once

#include <utility>

namespace coaster::curve::detail {

// Barrett 2012, section 2.1, term by term: 2 + 3 + 3 + 2 products of scalars, and four of a scalar and a vector.
template <class V, class S>
V bernstein(const V& p0, const V& p1, const V& p2, const V& p3, S t) {
  const S s = 1.0f - t;
  return s * s * s * p0 + 3.0f * t * s * s * p1 + 3.0f * t * t * s * p2 + t * t * t * p3;
}

// The first two rounds of Barrett 2012, section 3.2: the ends of the line that touches the curve at t.
template <class V, class S>
std::pair<V, V> tangent_line(const V& p0, const V& p1, const V& p2, const V& p3, S t) {
  const S s = 1.0f - t;
  const V a = s * p0 + t * p1, b = s * p1 + t * p2, d = s * p2 + t * p3;
  return {s * a + t * b, s * b + t * d};
}
template <class V, class S>
V de_casteljau(const V& p0, const V& p1, const V& p2, const V& p3, S t) {
  const auto [left, right] = tangent_line(p0, p1, p2, p3, t);
  return (1.0f - t) * left + t * right;
}

// Barrett 2012, section 3.3: three additions and three multiplications per point.
template <class V, class S>
V horner(V c0, V c1, V c2, V c3, S t) {
  return c0 + t * (c1 + t * (c2 + t * c3));
}

// Estrin's scheme: two independent halves, for one more multiplication (t^2).
template <class V, class S>
V estrin(V c0, V c1, V c2, V c3, S t) {
  return (c0 + t * c1) + (t * t) * (c2 + t * c3);
}

// Barrett 2012, section 3.4, for f = c0 + c1 t + c2 t^2 + c3 t^3 and step e. Paper erratum: "B(0) + i dB" holds only
// for a straight line; a cubic needs all three differences.
template <class V>
struct Differences {
  V value, first, second, third;
};
template <class V>
Differences<V> start_differences(V c0, V c1, V c2, V c3, float e) {
  const V cube = e * e * e * c3, square = e * e * c2;
  return {c0, cube + square + e * c1, 6.0f * cube + 2.0f * square, 6.0f * cube};
}
// Advances by one step: three vector additions.
template <class V>
void step(Differences<V>& d) {
  d.value = d.value + d.first;
  d.first = d.first + d.second;
  d.second = d.second + d.third;
}

// The same for the tangent c1 + 2 c2 t + 3 c3 t^2: a parabola, so only two additions per step.
template <class V>
struct TangentDifferences {
  V value, first, second;
};
template <class V>
TangentDifferences<V> start_tangent_differences(V c1, V c2, V c3, float e) {
  const V square = 3.0f * e * e * c3;
  return {c1, square + 2.0f * e * c2, 2.0f * square};
}
template <class V>
void step(TangentDifferences<V>& d) {
  d.value = d.value + d.first;
  d.first = d.first + d.second;
}

}  // namespace coaster::curve::detail
