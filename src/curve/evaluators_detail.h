// The inner loops of the evaluators over any vector type, so that a test can count their operations.
#pragma once

#include <cstddef>

#include "curve/cubic.h"

namespace coaster::curve::detail {

template <class V>
struct ControlPoints {
  V p0, p1, p2, p3;
};

// B(t) term by term: Barrett 2012, section 2.1.
template <class V>
V bernstein_point(const ControlPoints<V>& c, float t) {
  const float s = 1.0f - t;
  return s * s * s * c.p0 + 3.0f * t * s * s * c.p1 + 3.0f * t * t * s * c.p2 + t * t * t * c.p3;
}
template <class V>
V bernstein_tangent(const ControlPoints<V>& c, float t) {
  const float s = 1.0f - t;
  return 3.0f * s * s * (c.p1 - c.p0) + 6.0f * t * s * (c.p2 - c.p1) + 3.0f * t * t * (c.p3 - c.p2);
}

// The recurrence of Barrett 2012, section 3.2; the last row's difference gives the tangent.
template <class V>
struct CasteljauRow {
  V left, right;
};
template <class V>
CasteljauRow<V> casteljau(const ControlPoints<V>& c, float t) {
  const float s = 1.0f - t;
  const V a = s * c.p0 + t * c.p1, b = s * c.p1 + t * c.p2, d = s * c.p2 + t * c.p3;
  return {s * a + t * b, s * b + t * d};
}

// Barrett 2012, section 3.3: three additions and three multiplications per point.
template <class V>
V horner(V c0, V c1, V c2, V c3, float t) {
  return c0 + t * (c1 + t * (c2 + t * c3));
}

// Estrin's scheme: two independent halves, for one more multiplication (t^2).
template <class V>
V estrin(V c0, V c1, V c2, V c3, float t) {
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
// One step: three vector additions.
template <class V>
void step(Differences<V>& d) {
  d.value = d.value + d.first;
  d.first = d.first + d.second;
  d.second = d.second + d.third;
}

// The same for the tangent c1 + 2 c2 t + 3 c3 t^2: a parabola, so two additions per step.
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
