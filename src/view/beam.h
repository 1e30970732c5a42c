// The line of sight through a pixel and the cone about it: where a point appears beside the pixel, and which segments
// of a track may.
#pragma once

#include <array>
#include <limits>

#include "sim/shape/segment_tree.h"
#include "view/camera.h"

namespace coaster::view {

// A point relative to a pixel, in homogeneous form: it is seen (u/w, v/w) pixels from it at depth w, and lies between
// the near and the far plane when |z| <= w. All four are affine in the point, so those of a curve's control points are
// controls of the curve's.
struct Sighted {
  double u = 0, v = 0, w = 0, z = 0;
};
inline constexpr double kNowhere = std::numeric_limits<double>::infinity();  // the distance to what is not met
inline constexpr double kLeastDepth = 1e-4;  // m: what is not deeper counts as behind the eye
inline bool is_visible(const Sighted& s) { return s.w > kLeastDepth && s.z <= s.w && -s.z <= s.w; }

class Beam {
 public:
  // Of a perspective view: any other has no eye, and nothing is seen.
  Beam(const View& view, glm::dvec2 pixel);
  bool has_eye() const { return has_eye_; }

  Sighted operator()(glm::vec3 p) const {
    const auto row = [p](const glm::dvec4& r) { return r.x * p.x + r.y * p.y + r.z * p.z + r.w; };
    return {row(u_), row(v_), row(w_), row(z_)};
  }

  // In float and relative to the eye, for the tests of four boxes or chords at a time.
  struct Coarse {
    glm::vec3 eye{0};            // m, where u = v = w = 0
    glm::vec3 inverse{0};        // of the direction in which u = v = 0 and w grows by 1, never infinite
    glm::vec3 u{0}, v{0}, w{0};  // gradients, u and v divided by `pixels`
    float eye_depth = 0;         // w . eye
    double pixels = 1;           // px that a metre across the line of sight has at depth 1, at most
    double least_pixels = 1;     // the same in the direction where it has the fewest
    float stretch = 1;           // |change of (u, v)| / pixels that one metre makes, at most
    float rounding = 0;          // m, that coordinates and the eye are off by
  };
  const Coarse& coarse() const { return coarse_; }

 private:
  void set_coarse();
  glm::dvec4 u_{0}, v_{0}, w_{0}, z_{0};
  Coarse coarse_;
  bool has_eye_ = false;
};

// Calls visit(i) for every segment i of the track that may come within limit() pixels of the beam's pixel, and for some
// more; about the closest first. A visit may lower the limit: what is only within the old one may be left out from then
// on. Returns how many of the tree's nodes it looked into.
template <class Limit, class Visit>
std::size_t visit_near(const sim::SegmentTree& tree, const Beam& beam, Limit limit, Visit visit);

}  // namespace coaster::view

#include "view/beam_visit.h"
