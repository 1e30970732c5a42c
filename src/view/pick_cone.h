// The line of sight through a pixel and the cone around it: where a point appears relative to the pixel, and which
// segments of a track may appear near it.
#pragma once

#include <array>
#include <limits>

#include "sim/shape/segment_tree.h"
#include "view/camera.h"

namespace coaster::view {

// A point relative to a pixel, in homogeneous form: it appears (u/w, v/w) pixels from the pixel at depth w (1 in an
// orthographic view), and lies between the near and the far plane if |z| <= w. All four are affine in the point, so the
// values of a curve's control points are control values of the curve.
struct PixelRelative {
  double u = 0, v = 0, w = 0, z = 0;
};
inline constexpr double kNowhere = std::numeric_limits<double>::infinity();  // distance if nothing is hit
inline constexpr double kLeastDepth = 1e-4;  // m: smaller depths count as behind the eye
inline bool is_visible(const PixelRelative& s) { return s.w > kLeastDepth && s.z <= s.w && -s.z <= s.w; }

class PixelBeam {
 public:
  // `view` must be a perspective or an orthographic view. Any other has no eye, and nothing is seen.
  PixelBeam(const View& view, glm::dvec2 pixel);
  bool has_eye() const { return has_eye_; }

  // Metres by which depths of an orthographic view must differ for one to be in front; 0 for a perspective view.
  double same_depth() const { return same_depth_; }
  // Depth of a position on a curve, m: from the eye, or along an orthographic view.
  double depth(double w, glm::dvec3 place) const {
    return same_depth_ > 0 ? glm::dot(glm::dvec3(coarse_.w), place) : w;
  }

  PixelRelative operator()(glm::vec3 p) const {
    const auto row = [p](const glm::dvec4& r) { return r.x * p.x + r.y * p.y + r.z * p.z + r.w; };
    return {row(u_), row(v_), row(w_), row(z_)};
  }

  // The beam in float and relative to the eye, for tests of four boxes or chords at a time.
  struct Coarse {
    glm::vec3 eye{0};            // m, where u = v = w = 0
    glm::vec3 inverse{0};        // of the direction in which u = v = 0 and w grows by 1; never infinite
    glm::vec3 u{0}, v{0}, w{0};  // gradients, u and v divided by `pixels`
    float eye_depth = 0;         // w . eye
    double pixels = 1;           // pixels per metre across the line of sight at depth 1, at most
    double least_pixels = 1;     // the same in the direction where it is smallest
    float stretch = 1;           // largest |change of (u, v)| / pixels per metre
    float rounding = 0;          // m, error of coordinates and eye
  };
  const Coarse& coarse() const { return coarse_; }

 private:
  void set_coarse();
  void set_parallel(const View& view);
  glm::dvec4 u_{0}, v_{0}, w_{0}, z_{0};
  Coarse coarse_;
  double same_depth_ = 0;
  bool has_eye_ = false;
};

// Calls visit(i) for every segment i of the track that may come within limit() pixels of the beam's pixel, and for some
// others, roughly the closest first. A visit may lower the limit; segments that are only within the old limit may then
// be skipped. Returns the number of tree nodes visited.
template <class Limit, class Visit>
std::size_t visit_near(const sim::SegmentTree& tree, const PixelBeam& beam, Limit limit, Visit visit);

}  // namespace coaster::view

#include "view/pick_cone_traversal.h"
