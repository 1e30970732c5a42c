// The spline of NoLimits 2 elements: a uniform cubic B-spline that passes through its strict vertices; the others are
// control vertices.
#pragma once

#include <array>
#include <vector>

#include <glm/glm.hpp>

#include "curve/cubic.h"
#include "sim/shape/derived.h"

namespace coaster::exchange {

struct SplineVertex {
  glm::dvec3 position{0};  // m
  bool strict = false;     // the curve passes through it
};

class UniformSpline {
 public:
  // Needs 2 vertices, 3 if closed. An open spline starts at the first vertex and ends at the last one, with curvature 0
  // there; a closed one continues from the last vertex to the first.
  UniformSpline(const std::vector<SplineVertex>& vertices, bool closed);

  std::size_t spans() const { return closed_ ? controls_.size() : controls_.size() - 1; }
  // Returns the Bézier control points of the curve between two neighbouring vertices, exact to rounding: (V0 + 4 V1 +
  // V2)/6, (2 V1 + V2)/3, (V1 + 2 V2)/3, (V1 + 4 V2 + V3)/6.
  std::array<glm::dvec3, 4> span(std::size_t i) const;

 private:
  glm::dvec3 control(std::ptrdiff_t i) const;  // also one before the first and one after the last
  std::vector<glm::dvec3> controls_;
  bool closed_;
};

// Returns a span as a cubic of the document, rounded to float.
inline curve::Cubic in_float(const std::array<glm::dvec3, 4>& c) {
  return {glm::vec3(c[0]), glm::vec3(c[1]), glm::vec3(c[2]), glm::vec3(c[3])};
}

// The rails at a distance along the track, for both files of NoLimits 2.
struct PlaceOnTrack {
  glm::dvec3 position;
  curve::Frame frame;
};
PlaceOnTrack place_on(const sim::Derived& derived, double distance);

}  // namespace coaster::exchange
