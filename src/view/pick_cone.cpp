#include "view/pick_cone.h"

#include <algorithm>
#include <cmath>

namespace coaster::view {
namespace {

using glm::dvec2;
using glm::dvec3;
using glm::dvec4;

struct SingularValues {
  double least = 0, most = 0;
};

// Returns bounds of the singular values of two rows by Gershgorin's discs; exact if the rows are perpendicular and of
// equal length, as for square pixels.
SingularValues singular_values(dvec3 a, dvec3 b) {
  const double aa = glm::dot(a, a), bb = glm::dot(b, b), ab = std::abs(glm::dot(a, b));
  return {std::sqrt(std::max(std::min(aa, bb) - ab, 0.0)), std::sqrt(std::max(aa, bb) + ab)};
}

float inverse_of(double x) {
  constexpr double kLeast = 1e-18;  // keeps a coordinate times the inverse finite
  return static_cast<float>(1.0 / (std::abs(x) > kLeast ? x : std::copysign(kLeast, x)));
}

}  // namespace

PixelBeam::PixelBeam(const View& view, dvec2 pixel) {
  const glm::mat4 &p = view.projection, &m = view.view;
  // Returns row `row` of projection times view.
  const auto clip = [&](int row) {
    dvec4 sum(0);
    for (int k = 0; k < 4; ++k) sum += static_cast<double>(p[k][row]) * dvec4(m[0][k], m[1][k], m[2][k], m[3][k]);
    return sum;
  };
  const Viewport& port = view.viewport;
  const double half_width = 0.5 * port.width, half_height = 0.5 * port.height;
  w_ = clip(3);
  if (view.parallel > 0) {
    z_ = clip(2);
    u_ = half_width * clip(0) + (port.x + half_width - pixel.x) * w_;
    v_ = -half_height * clip(1) + (port.y + half_height - pixel.y) * w_;
    set_parallel(view);
    return;
  }
  const double metre = glm::length(dvec3(w_));
  if (!(metre > 0) || !std::isfinite(metre)) return;
  const double scale = 1 / metre;
  w_ *= scale;
  z_ = scale * clip(2);
  u_ = (half_width * scale) * clip(0) + (port.x + half_width - pixel.x) * w_;
  v_ = (-half_height * scale) * clip(1) + (port.y + half_height - pixel.y) * w_;
  set_coarse();
}

// The cylinder about the line of sight is within a cone from a far point of that line, whose radius is exact where the
// view begins and at most twice as large where it ends.
void PixelBeam::set_parallel(const View& view) {
  constexpr double kSameDepth = 1e-3;  // of the distance of the subject
  const dvec3 u(u_), v(v_), forward(line_of_sight(view));
  const double pixels = glm::length(u), depth = 1 / glm::length(dvec3(z_));  // a metre in px; m from the eye to a plane
  if (!(pixels > 0) || !std::isfinite(depth)) return;
  // Where u = v = 0, in the plane of the eye, then four depths behind it.
  const dvec3 at(view.eye), off = dvec3(glm::dot(u, at) + u_.w, glm::dot(v, at) + v_.w, 0) / (pixels * pixels);
  const dvec3 eye = at - off.x * u - off.y * v - 3 * depth * forward;
  const double least_depth = 2 * depth;
  Coarse& c = coarse_;
  c.eye = glm::vec3(eye);
  c.eye_depth = static_cast<float>(glm::dot(forward, eye));
  c.inverse = {inverse_of(forward.x), inverse_of(forward.y), inverse_of(forward.z)};
  c.pixels = c.least_pixels = pixels * least_depth;
  c.stretch = 1 + 1e-6f;
  c.u = glm::vec3(u / pixels), c.v = glm::vec3(v / pixels), c.w = glm::vec3(forward);
  c.rounding = static_cast<float>(1e-6 * (std::abs(eye.x) + std::abs(eye.y) + std::abs(eye.z)));
  same_depth_ = kSameDepth * static_cast<double>(view.parallel);
  has_eye_ = true;
}

void PixelBeam::set_coarse() {
  const dvec3 u(u_), v(v_), w(w_), across = glm::cross(u, v);
  const double inverse = 1 / glm::dot(across, w);
  const dvec3 eye = -inverse * (u_.w * glm::cross(v, w) + v_.w * glm::cross(w, u) + w_.w * across),
              forward = inverse * across;
  const SingularValues pixels = singular_values(u - glm::dot(u, w) * w, v - glm::dot(v, w) * w);
  if (!(pixels.least > 1e-3)) return;  // the three have no common zero: there is no eye
  Coarse& c = coarse_;
  c.eye = glm::vec3(eye);
  c.eye_depth = static_cast<float>(glm::dot(w, eye));
  c.inverse = {inverse_of(forward.x), inverse_of(forward.y), inverse_of(forward.z)};
  c.pixels = pixels.most;
  c.least_pixels = pixels.least;
  c.stretch = static_cast<float>(singular_values(u, v).most / c.pixels * (1 + 1e-6));
  c.u = glm::vec3((1 / c.pixels) * u), c.v = glm::vec3((1 / c.pixels) * v), c.w = glm::vec3(w);
  c.rounding = static_cast<float>(1e-6 * (std::abs(eye.x) + std::abs(eye.y) + std::abs(eye.z)));
  has_eye_ = true;
}

}  // namespace coaster::view
