#include "sim/study/vertex_rounding.h"

#include <algorithm>

#include "base/check.h"

namespace coaster::sim {

Rounding rounding(const curve::PreparedCubic& curve, const curve::Evaluator& evaluator, int steps) {
  COASTER_CHECK(steps >= curve::kMinSteps && steps <= curve::kMaxSteps, "polylines have 1 to 4096 steps");
  const auto vertices = static_cast<std::size_t>(steps) + 1;
  std::vector<glm::vec3> points(vertices);
  evaluator.polyline(curve, points, {});
  Rounding result;
  result.exact.reserve(vertices), result.error.reserve(vertices);
  for (std::size_t i = 0; i < vertices; ++i) {
    result.exact.push_back(curve::point_long_double(curve.cubic, static_cast<double>(i) / steps));
    result.error.push_back(glm::dvec3(points[i]) - result.exact.back());
  }
  return result;
}

double largest(const Rounding& rounding) {
  double most = 0;
  for (const glm::dvec3 e : rounding.error) most = std::max(most, glm::length(e));
  return most;
}

double seam(const Rounding& rounding) {
  return rounding.error.size() < 3 ? 0.0 : glm::length(rounding.error[rounding.error.size() - 2]);
}

std::vector<ErrorSample> error_profile(const curve::PreparedCubic& curve, const curve::Evaluator& evaluator,
                                       int steps) {
  const Rounding r = rounding(curve, evaluator, steps);
  std::vector<ErrorSample> samples;
  samples.reserve(r.error.size());
  for (std::size_t i = 0; i < r.error.size(); ++i)
    samples.push_back({static_cast<double>(i) / steps, 1e3 * glm::length(r.error[i])});
  return samples;
}

}  // namespace coaster::sim
