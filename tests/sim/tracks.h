// Tracks for the tests of derived data, built by hand: skew, off-origin, with known shapes.
#pragma once

#include <cmath>

#include "sim/shape/derived_track.h"
#include "world/sample_documents.h"

namespace coaster::test {

inline sim::DerivedTrack derived_of(const world::Document& document, const world::Settings& settings = {}) {
  sim::DerivedTrack derived;
  sim::derive(document, settings, {}, derived);
  return derived;
}

// Splits a segment at its parameter t, where the new knot takes the track's own `up`.
inline void split_at(world::Document& document, world::Entity segment, double t) {
  const sim::DerivedTrack derived = sim::shapes_of(document);
  const sim::SegmentShape& shape = derived.shape(segment);
  world::split_segment(document, segment, t, glm::vec3(sim::frame_at(shape, shape.arc.distance(t)).up));
}

// The vertices of a segment's polyline.
inline std::vector<glm::vec3> polyline_of(const sim::SegmentShape& shape) {
  sim::Polyline polyline;
  sim::evaluate_polyline(shape, polyline);
  return polyline.points;
}

// A closed track of `count` knots about a tilted ring of `radius` metres with hills; all joints smooth.
inline world::Document ring_document(int count, double radius, double hill = 3.7) {
  world::Document d;
  const double step = 2 * M_PI / count;
  const auto handle = static_cast<float>(radius * step / 3);
  for (int i = 0; i < count; ++i) {
    const double a = step * i + 0.137, wave = 3 * a;
    const glm::vec3 position(13.3 + radius * std::cos(a), 21.7 + hill * std::sin(wave), -7.9 - radius * std::sin(a));
    const glm::vec3 tangent(-radius * std::sin(a), 3 * hill * std::cos(wave), -radius * std::cos(a));
    world::append_knot(d, skew_knot(position, tangent, handle, handle, world::JointKind::smooth));
  }
  world::set_closed(d, true);
  return d;
}

// A straight from `from` to `to` in `segments` segments.
inline world::Document straight_document(glm::vec3 from, glm::vec3 to, int segments = 1) {
  world::Document d;
  const float third = glm::distance(from, to) / static_cast<float>(3 * segments);
  for (int i = 0; i <= segments; ++i)
    world::append_knot(d, skew_knot(glm::mix(from, to, static_cast<float>(i) / static_cast<float>(segments)), to - from,
                                    third, third));
  return d;
}

// A vertical circle in the plane of `forward` and +Y, through its lowest point, as close to round as cubics get: 64
// segments are within 1e-9 of the radius. `up` points to the centre.
inline world::Document circle_document(double radius, glm::dvec3 bottom, glm::dvec3 forward, int count = 64) {
  world::Document d;
  forward = glm::normalize(forward);
  const double step = 2 * M_PI / count;
  const auto handle = static_cast<float>(4.0 / 3.0 * std::tan(step / 4) * radius);
  for (int i = 0; i < count; ++i) {
    const double a = step * i;
    const glm::dvec3 out = std::sin(a) * forward - std::cos(a) * glm::dvec3(0, 1, 0),
                     along = std::cos(a) * forward + std::sin(a) * glm::dvec3(0, 1, 0);
    world::Knot k =
        skew_knot(glm::vec3(bottom + radius * (out + glm::dvec3(0, 1, 0))), glm::vec3(along), handle, handle);
    k.up = glm::vec3(-out);
    world::orthonormalise(k);
    world::append_knot(d, k);
  }
  world::set_closed(d, true);
  return d;
}

}  // namespace coaster::test
