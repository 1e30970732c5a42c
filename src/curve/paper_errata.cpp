#include "curve/paper_errata.h"

#include <algorithm>
#include <array>

#include "curve/frames.h"

namespace coaster::curve {
namespace {

using glm::dvec2;
using glm::dvec3;

constexpr double kHalfSpan = 1.0 / 64;  // of t: the normal's turn is that within twice this

// The control points projected along the mean normal of the closed polygon p0 p1 p2 p3 (Newell's); empty if they are
// collinear.
struct ControlPolygonPlane {
  bool flat = false;
  dvec3 origin{0}, right{1, 0, 0}, up{0, 1, 0};
  dvec2 operator()(dvec3 p) const { return {glm::dot(p - origin, right), glm::dot(p - origin, up)}; }
};
ControlPolygonPlane view_of(const Cubic& c) {
  const dvec3 p[] = {dvec3(c.p0), dvec3(c.p1), dvec3(c.p2), dvec3(c.p3)};
  dvec3 normal(0);
  double size = 0;
  for (int i = 0; i < 4; ++i) normal += glm::cross(p[i] - p[0], p[(i + 1) % 4] - p[0]);
  for (int i = 1; i < 4; ++i) size = std::max(size, glm::length(p[i] - p[0]));
  // A polygon that crosses itself can have no mean normal: use any normal of its plane.
  for (int i = 1; i < 4 && !(glm::length(normal) > 1e-9 * size * size); ++i)
    for (int k = i + 1; k < 4 && !(glm::length(normal) > 1e-9 * size * size); ++k)
      normal = glm::cross(p[i] - p[0], p[k] - p[0]);
  ControlPolygonPlane view;
  view.origin = p[0];
  if (!(glm::length(normal) > 1e-9 * size * size) || !(size > 0)) return view;
  normal = glm::normalize(normal);
  view.flat = true;
  view.right = perpendicular(normal, {1, 0, 0});
  view.up = glm::cross(normal, view.right);
  return view;
}

double distance_to_edge(dvec2 p, dvec2 a, dvec2 b) {
  const dvec2 d = b - a;
  const double squared = glm::dot(d, d);
  const double t = squared > 0 ? std::clamp(glm::dot(p - a, d) / squared, 0.0, 1.0) : 0.0;
  return glm::length(p - a - t * d);
}

// Returns 0 inside the closed polygon (even-odd), else the distance to it.
double outside(dvec2 p, const std::array<dvec2, 4>& polygon) {
  bool inside = false;
  double nearest = 1e300;
  for (std::size_t i = 0; i < 4; ++i) {
    const dvec2 a = polygon[i], b = polygon[(i + 1) % 4];
    nearest = std::min(nearest, distance_to_edge(p, a, b));
    if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x)) inside = !inside;
  }
  return inside ? 0.0 : nearest;
}

}  // namespace

GravesenClaim gravesen_claim(const Cubic& c) {
  const double chord = glm::length(dvec3(c.p3) - dvec3(c.p0));
  const double polygon = glm::length(dvec3(c.p1) - dvec3(c.p0)) + glm::length(dvec3(c.p2) - dvec3(c.p1)) +
                         glm::length(dvec3(c.p3) - dvec3(c.p2));
  return {0.5 * polygon * chord, 0.5 * (polygon + chord)};
}

double line_claim(const Cubic& cubic, int steps) {
  constexpr int kMostSteps = 4096;
  const int n = std::clamp(steps, 1, kMostSteps);
  const dvec3 start = point(cubic, 0.0), difference = point(cubic, 1.0 / n) - start;
  double worst = 0;
  for (int i = 0; i <= n; ++i)
    worst = std::max(
        worst, glm::length(start + static_cast<double>(i) * difference - point(cubic, static_cast<double>(i) / n)));
  return worst;
}

FlipClaim flip_claim(const Cubic& cubic) {
  const BinormalCurve binormal = binormal_curve(cubic);
  const BinormalTurns turns = binormal_turns(binormal);
  FlipClaim worst{0.5, 0, frenet(cubic, 0.5).has_value()};
  const auto look_at = [&](const BinormalTurn& turn, bool defined) {
    if (!defined) return;
    worst.defined = true;
    // Where the curve nearly has a cusp the normal may tip over and return: it turns most from a side to the middle.
    const double angle =
        std::max({turn.angle, binormal_turn(binormal, turn.from, turn.t), binormal_turn(binormal, turn.t, turn.to)});
    if (angle > worst.frenet_angle) worst.frenet_angle = angle, worst.t = turn.t;
  };
  // The normal turns fastest at the minima of |B' x B''|; without one, at an end or in the middle.
  const auto defined = [&](double t) { return frenet(cubic, std::clamp(t, 0.0, 1.0)).has_value(); };
  for (int i = 0; i < turns.count; ++i)
    look_at(turns.at[i], defined(turns.at[i].t - kHalfSpan) && defined(turns.at[i].t + kHalfSpan));
  for (const double t : {0.0, 0.5, 1.0}) {
    const double from = std::max(0.0, t - kHalfSpan), to = std::min(1.0, t + kHalfSpan);
    look_at({t, from, to, binormal_turn(binormal, from, to)}, defined(from) && defined(to));
  }
  return worst;
}

double pen_claim(const Cubic& cubic) {
  constexpr int kPlaces = 128;
  const ControlPolygonPlane view = view_of(cubic);
  if (!view.flat) return 0;
  const std::array pen{view(dvec3(cubic.p0)), view(dvec3(cubic.p1)), view(dvec3(cubic.p2)), view(dvec3(cubic.p3))};
  double worst = 0;
  for (int i = 0; i <= kPlaces; ++i)
    worst = std::max(worst, outside(view(point(cubic, static_cast<double>(i) / kPlaces)), pen));
  return worst;
}

}  // namespace coaster::curve
