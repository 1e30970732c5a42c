#include "exchange/nolimits/nl2_spline.h"

#include <algorithm>

#include "base/check.h"

namespace coaster::exchange {

using glm::dvec3;

UniformSpline::UniformSpline(const std::vector<SplineVertex>& vertices, bool closed) : closed_(closed) {
  COASTER_CHECK(vertices.size() >= (closed ? 3u : 2u), "a spline has a span");
  for (const SplineVertex& v : vertices) controls_.push_back(v.position);
  // C[i-1] + 4 C[i] + C[i+1] = 6 V[i] for strict vertices, by Gauss-Seidel: each sweep leaves a quarter of the error,
  // so 40 are exact in double.
  const auto count = static_cast<std::ptrdiff_t>(controls_.size());
  for (int sweep = 0; sweep < 40; ++sweep)
    for (std::ptrdiff_t i = closed ? 0 : 1; i < (closed ? count : count - 1); ++i)
      if (const SplineVertex& v = vertices[static_cast<std::size_t>(i)]; v.strict)
        controls_[static_cast<std::size_t>(i)] = (6.0 * v.position - control(i - 1) - control(i + 1)) / 4.0;
}

dvec3 UniformSpline::control(std::ptrdiff_t i) const {
  const auto count = static_cast<std::ptrdiff_t>(controls_.size());
  if (closed_) return controls_[static_cast<std::size_t>((i + count) % count)];
  if (i < 0) return 2.0 * controls_[0] - controls_[1];
  if (i >= count)
    return 2.0 * controls_[static_cast<std::size_t>(count - 1)] - controls_[static_cast<std::size_t>(count - 2)];
  return controls_[static_cast<std::size_t>(i)];
}

std::array<dvec3, 4> UniformSpline::span(std::size_t i) const {
  const auto at = static_cast<std::ptrdiff_t>(i);
  const dvec3 a = control(at - 1), b = control(at), c = control(at + 1), d = control(at + 2);
  return {(a + 4.0 * b + c) / 6.0, (2.0 * b + c) / 3.0, (b + 2.0 * c) / 3.0, (b + 4.0 * c + d) / 6.0};
}

PlaceOnTrack place_on(const sim::Derived& derived, double distance) {
  const sim::TrackPlace at = sim::place_at(derived, distance);
  const sim::SegmentShape& shape = derived.shape(derived.order[at.index]);
  const double within = std::min(at.s, shape.arc.length());
  return {curve::point(shape.key.cubic, shape.arc.parameter(within)), sim::frame_at(shape, within)};
}

}  // namespace coaster::exchange
