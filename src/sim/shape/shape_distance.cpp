#include "sim/shape/shape_distance.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace coaster::sim {
namespace {

double square_distance(const glm::dvec3& p, const glm::dvec3& a, const glm::dvec3& b) {
  const glm::dvec3 ab = b - a, ap = p - a;
  const double square = glm::dot(ab, ab), t = square > 0 ? std::clamp(glm::dot(ap, ab) / square, 0.0, 1.0) : 0.0;
  const glm::dvec3 apart = ap - t * ab;
  return glm::dot(apart, apart);
}

// Returns the squared largest distance of the points of `from` to the polygon `to`. Consecutive points are close, so
// the search starts where the last one ended, and stops once it finds anything nearer than the largest distance so far:
// that point cannot raise it.
double directed(const std::vector<glm::dvec3>& from, const std::vector<glm::dvec3>& to) {
  const std::size_t spans = std::max<std::size_t>(1, to.size() - 1);
  double largest = 0;
  std::size_t start = 0;
  for (const glm::dvec3& p : from) {
    double nearest = std::numeric_limits<double>::infinity();
    std::size_t where = start;
    for (std::size_t i = 0; i < spans && nearest > largest; ++i) {
      const std::size_t span = (start + i) % spans;
      const double d = square_distance(p, to[span], to[std::min(span + 1, to.size() - 1)]);
      if (d < nearest) nearest = d, where = span;
    }
    start = where;
    largest = std::max(largest, nearest);
  }
  return largest;
}

}  // namespace

ShapeTrace trace_of(const world::Document& document) {
  ShapeTrace trace;
  const std::size_t segments = document.track.segments.size();
  if (segments == 0) {
    for (const world::Entity e : document.track.knots) trace.points.emplace_back(world::knot(document, e).position);
    return trace;
  }
  const std::size_t steps = std::max<std::size_t>(segments > kTracePoints ? 1 : 8, kTracePoints / segments);
  for (const world::Entity e : document.track.segments) {
    const curve::Cubic cubic = world::cubic_of(document, e);
    if (trace.points.empty()) trace.points.emplace_back(cubic.p0);
    for (std::size_t i = 1; i <= steps; ++i)
      trace.points.push_back(curve::point(cubic, static_cast<double>(i) / static_cast<double>(steps)));
  }
  return trace;
}

double shape_distance(const ShapeTrace& a, const ShapeTrace& b) {
  if (a.points.empty() || b.points.empty())
    return a.points.empty() == b.points.empty() ? 0.0 : std::numeric_limits<double>::infinity();
  return std::sqrt(std::max(directed(a.points, b.points), directed(b.points, a.points)));
}

}  // namespace coaster::sim
