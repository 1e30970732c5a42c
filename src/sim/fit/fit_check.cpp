// Measures the distance of a document from the rows it was fitted to, on the displayed curves and frames.
#include <algorithm>

#include "base/check.h"
#include "sim/fit/fit_track.h"

namespace coaster::sim {
namespace {

using glm::dvec3;

// Returns the nearest parameter by Newton's method from `t`; searches the whole segment if that fails.
curve::NearestPoint nearest_from(const curve::Cubic& cubic, const curve::CoefficientsD& c, dvec3 target, double t) {
  for (int i = 0; i < 4; ++i) {
    const dvec3 off = c.point(t) - target, d = c.derivative(t);
    const double slope = glm::dot(d, d) + glm::dot(off, c.second_derivative(t));
    if (!(slope > 0)) break;
    t = std::clamp(t - glm::dot(off, d) / slope, 0.0, 1.0);
  }
  const double distance = glm::distance(curve::point(cubic, t), target);
  return distance <= 0.5 * kFitDistance ? curve::NearestPoint{t, distance} : curve::nearest_point(cubic, target);
}

}  // namespace

std::vector<FitReport> measure_spans(const Derived& derived, std::span<const FitRow> rows,
                                     std::span<const std::size_t> ends, std::span<const char> free,
                                     std::span<const char> given) {
  COASTER_CHECK(ends.size() == derived.order.size() + 1, "every segment covers a span of rows");
  std::vector<FitReport> reports(derived.order.size());
  for (std::size_t i = 0; i < reports.size(); ++i) {
    const SegmentShape& shape = derived.shape_at(i);
    const curve::CoefficientsD c = curve::coefficients_d(shape.key.cubic);
    double guess = 0;
    for (std::size_t k = ends[i]; k <= ends[i + 1]; ++k) {
      const std::size_t r = k < rows.size() ? k : 0;
      // Starts from the previous row's parameter plus a mean step.
      const double mean = 1.0 / static_cast<double>(ends[i + 1] - ends[i]);
      const double start = k == ends[i] ? 0.0 : k == ends[i + 1] ? 1.0 : std::min(1.0, guess + mean);
      const curve::NearestPoint near = nearest_from(shape.key.cubic, c, rows[r].position, start);
      guess = near.t;
      if (!given[r]) continue;
      reports[i].max_error = std::max(reports[i].max_error, near.distance);
      const curve::Frame frame = frame_at(shape, shape.arc.distance(near.t));
      const double angle = frame_angle_deg(frame, {rows[r].forward, rows[r].up});
      double& worst = free[r] ? reports[i].jump_error : reports[i].frame_error;
      worst = std::max(worst, angle);
      // A row between two spans counts once in the mean squares.
      if (k == ends[i + 1] && (i + 1 < reports.size() || k == rows.size())) continue;
      reports[i].distances.add(near.distance);
      if (!free[r]) reports[i].angles.add(angle);
    }
  }
  return reports;
}

}  // namespace coaster::sim
