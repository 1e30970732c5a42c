#include "view/pick_cone.h"

#include <algorithm>
#include <cmath>

#include "curve/polynomial_roots.h"

namespace coaster::view {
namespace {

using Bernstein8 = std::array<double, 9>;
using Four64 = std::array<double, 4>;
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

using curve::Bracket, curve::each_rise, curve::each_root, curve::product;

// Homogeneous screen coordinates as Bernstein coefficients.
struct ScreenCurve {
  Four64 u, v, w;
};

ScreenCurve screen_of(const SightedControls& c) {
  return {{c[0].u, c[1].u, c[2].u, c[3].u}, {c[0].v, c[1].v, c[2].v, c[3].v}, {c[0].w, c[1].w, c[2].w, c[3].w}};
}

// Returns the Bernstein coefficients of N.
Bernstein8 slope_polynomial(const ScreenCurve& s) {
  std::array<glm::dvec2, 4> place;
  for (std::size_t i = 0; i < 4; ++i) place[i] = {s.u[i], s.v[i]};
  const auto slope = [](const auto& c) {
    return std::array{3.0 * (c[1] - c[0]), 3.0 * (c[2] - c[1]), 3.0 * (c[3] - c[2])};
  };
  const Bernstein8 away = product(product(place, place), slope(s.w));
  Bernstein8 n = product(product(place, slope(place)), s.w);
  for (std::size_t i = 0; i < n.size(); ++i) n[i] -= away[i];
  return n;
}

// A cubic's value and two derivatives.
struct Jet {
  double value, first, second;
};
Jet jet(const Four64& c, double t) {
  const double c1 = 3 * (c[1] - c[0]), c2 = 3 * (c[0] - 2 * c[1] + c[2]), c3 = c[3] - c[0] + 3 * (c[1] - c[2]);
  return {c[0] + t * (c1 + t * (c2 + t * c3)), c1 + t * (2 * c2 + t * 3 * c3), 2 * c2 + 6 * t * c3};
}

SightedPlace place_at(const ScreenCurve& s, double t) {
  if (t == 0 || t == 1) {
    const std::size_t i = t == 0 ? 0 : 3;
    return {t, (s.u[i] * s.u[i] + s.v[i] * s.v[i]) / (s.w[i] * s.w[i]), s.w[i]};
  }
  const double u = jet(s.u, t).value, v = jet(s.v, t).value, w = jet(s.w, t).value;
  return {t, (u * u + v * v) / (w * w), w};
}

// Newton's method on N inside a bracket where it goes from negative to positive; bisects where a step would leave it.
double refined(const ScreenCurve& s, Bracket at) {
  constexpr int kMostSteps = 60;
  double t = at.guess;
  for (int i = 0; i < kMostSteps; ++i) {
    const Jet u = jet(s.u, t), v = jet(s.v, t), w = jet(s.w, t);
    const double square = u.value * u.value + v.value * v.value, towards = u.value * u.first + v.value * v.first;
    const double n = towards * w.value - square * w.first;
    if (n == 0) return t;
    (n < 0 ? at.low : at.high) = t;
    const double bend = u.first * u.first + v.first * v.first + u.value * u.second + v.value * v.second;
    const double slope = bend * w.value - towards * w.first - square * w.second;
    double next = t - n / slope;
    if (!(next > at.low && next < at.high)) next = 0.5 * (at.low + at.high);
    if (std::abs(next - t) < 1e-7) return next;  // the error is about the square of the step
    t = next;
  }
  return t;
}

int sign(double x) { return x > 0 ? 1 : x < 0 ? -1 : 0; }

// Returns the sign of the first coefficient that is not 0.
template <class It>
int first_sign(It from, It to) {
  const It found = std::find_if(from, to, [](double c) { return c != 0; });
  return found == to ? 0 : sign(*found);
}

void add(SightedPlaces& places, const SightedPlace& place) {
  if (places.count < kMaxSightedPlaces) places.items[static_cast<std::size_t>(places.count++)] = place;
}

// Adds the nearest positions of a curve that is wholly in front of the eye.
void add_places(const ScreenCurve& s, double from, double to, SightedPlaces& places) {
  const auto in_whole = [&](SightedPlace place) {
    place.t = place.t == 1 ? to : from + place.t * (to - from);
    return place;
  };
  const Bernstein8 n = slope_polynomial(s);
  if (first_sign(n.begin(), n.end()) >= 0) add(places, in_whole(place_at(s, 0)));
  each_rise(n, [&](const Bracket& bracket) { add(places, in_whole(place_at(s, refined(s, bracket)))); });
  if (first_sign(n.rbegin(), n.rend()) < 0) add(places, in_whole(place_at(s, 1)));
}

ScreenCurve restricted(const ScreenCurve& s, double from, double to) {
  const auto part = [&](Four64 c) {
    // Blossoms: the controls of [from, to] are c(f,f,f), c(f,f,t), c(f,t,t), c(t,t,t).
    const auto blossom = [&c](double x, double y, double z) {
      const auto mix = [](double a, double b, double t) { return (1 - t) * a + t * b; };
      const double a = mix(c[0], c[1], x), b = mix(c[1], c[2], x), d = mix(c[2], c[3], x);
      return mix(mix(a, b, y), mix(b, d, y), z);
    };
    return Four64{blossom(from, from, from), blossom(from, from, to), blossom(from, to, to), blossom(to, to, to)};
  };
  return {part(s.u), part(s.v), part(s.w)};
}

// Splits where the curve becomes visible or invisible: roots of its depth and of its distances from the two planes.
void add_visible_parts(const SightedControls& c, const ScreenCurve& s, SightedPlaces& places) {
  std::array<double, 11> ends{};
  std::size_t count = 1;
  const auto add_roots = [&](auto value) {
    each_root(std::array<double, 4>{value(c[0]), value(c[1]), value(c[2]), value(c[3])},
              [&](double t) { ends[count++] = t; });
  };
  add_roots([](const PixelRelative& p) { return p.w - kLeastDepth; });
  add_roots([](const PixelRelative& p) { return p.w - p.z; });
  add_roots([](const PixelRelative& p) { return p.w + p.z; });
  ends[count++] = 1;
  std::sort(ends.begin(), ends.begin() + static_cast<std::ptrdiff_t>(count));
  for (std::size_t i = 0; i + 1 < count; ++i) {
    // Slightly inside, so that rounding leaves no end behind the eye.
    const double hair = 1e-9 * (ends[i + 1] - ends[i]);
    const double from = i == 0 ? 0 : ends[i] + hair, to = i + 2 == count ? 1 : ends[i + 1] - hair;
    if (!(to - from > 1e-9)) continue;
    const double middle = 0.5 * (from + to);
    const Four64 z{c[0].z, c[1].z, c[2].z, c[3].z};
    const ScreenCurve part = restricted(s, from, to);
    if (!is_visible({0, 0, jet(s.w, middle).value, jet(z, middle).value})) continue;
    if (!(part.w.front() > 0 && part.w.back() > 0)) continue;
    add_places(part, from, to, places);
  }
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

SightedControls sighted(const curve::Cubic& cubic, const PixelBeam& beam) {
  return {beam(cubic.p0), beam(cubic.p1), beam(cubic.p2), beam(cubic.p3)};
}

bool may_come_near(const SightedControls& c, double limit) {
  for (const PixelRelative& p : c)
    if (!(p.w > kLeastDepth)) return true;
  // The hull is on one side of the pixel, by the limit, along the chord's normal or its direction, as a line of
  // homogeneous points.
  double x = c[3].u * c[0].w - c[0].u * c[3].w, y = c[3].v * c[0].w - c[0].v * c[3].w;
  const double length = std::sqrt(x * x + y * y);
  if (!(length > 0)) x = 1, y = 0;
  else x /= length, y /= length;
  bool left = true, right = true, ahead = true, behind = true;
  for (const PixelRelative& p : c) {
    const double side = x * p.v - y * p.u, along = x * p.u + y * p.v, reach = limit * p.w;
    left = left && side > reach, right = right && side < -reach;
    ahead = ahead && along > reach, behind = behind && along < -reach;
  }
  return !(left || right || ahead || behind);
}

SightedPlaces nearest_places(const SightedControls& controls) {
  SightedPlaces places;
  const ScreenCurve screen = screen_of(controls);
  if (std::all_of(controls.begin(), controls.end(), is_visible)) add_places(screen, 0, 1, places);
  else add_visible_parts(controls, screen, places);
  return places;
}

int slope_at_end(const SightedControls& controls, int end) {
  const Bernstein8 n = slope_polynomial(screen_of(controls));
  return sign(end == 0 ? n.front() : n.back());
}

}  // namespace coaster::view
