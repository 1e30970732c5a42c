// Measures the evaluators. Rows are interleaved in every round, so that other load on the machine affects all of them
// alike.
#include "sim/study/evaluator_benchmark.h"

#include <algorithm>

#include <fmt/format.h>

#include "base/check.h"
#include "sim/shape/shape_distance.h"

namespace coaster::sim {
namespace {

// The round and the number of steps of a time. Rounds are outermost, so that a first table is complete early.
struct TimingPass {
  std::size_t column;
  int round;
};
TimingPass share_of(int timed) {
  const int columns = static_cast<int>(kMeasuredSteps.size());
  return {static_cast<std::size_t>(timed % columns), timed / columns};
}

double checksum_of(std::span<const glm::vec3> points) {
  glm::vec3 sum(0);
  for (const glm::vec3 p : points) sum += p;
  return static_cast<double>(sum.x) + static_cast<double>(sum.y) + static_cast<double>(sum.z);
}

// Returns the median of the rounds.
double median(std::span<const double> values) {
  std::array<double, kMeasureRounds> sorted{};
  std::copy(values.begin(), values.end(), sorted.begin());
  const auto end = sorted.begin() + static_cast<std::ptrdiff_t>(values.size());
  std::sort(sorted.begin(), end);
  const std::size_t half = values.size() / 2;
  return values.size() % 2 == 1 ? sorted[half] : 0.5 * (sorted[half - 1] + sorted[half]);
}

void time_row(Measurement& m, MeasuredRow& row, TimingPass share, std::span<glm::vec3> points, const Clock& clock) {
  const curve::Evaluator& evaluator = base::row_of(row.evaluator);
  MeasuredCell& cell = row.cells[share.column];
  cell.rounds = share.round + 1;
  if (!row.is_timed()) return;
  const int segments = std::max(1, kMeasuredPoints / static_cast<int>(points.size()));
  const std::size_t curves = std::min(m.curves.size(), kTimedCurves);
  const double began = clock ? clock() : 0;
  for (int i = 0; i < segments; ++i) {
    evaluator.polyline(m.curves[static_cast<std::size_t>(i) % curves * m.curves.size() / curves], points, {});
    // Reads one vertex of each, so that the compiler cannot omit writing the results.
    m.checksum += static_cast<double>(points[points.size() / 2].x);
  }
  const double ended = clock ? clock() : 0;
  m.checksum += checksum_of(points);
  std::array<double, kMeasureRounds>& seconds = row.seconds[share.column];
  seconds[static_cast<std::size_t>(share.round)] =
      (ended - began) / (static_cast<double>(segments) * static_cast<double>(points.size()));
  cell.ns_per_point = 1e9 * median(std::span(seconds).first(static_cast<std::size_t>(cell.rounds)));
}

std::size_t searched_at_once(int steps) { return static_cast<std::size_t>(std::max(1, kErrorPoints / (steps + 1))); }

// Compares every vertex of the next segments with the exact point at the same t. Returns true after the last segment.
bool find_errors(Measurement& m, std::size_t column, std::span<glm::vec3> points) {
  const std::size_t end = std::min(m.curves.size(), m.searched + searched_at_once(kMeasuredSteps[column]));
  for (MeasuredRow& row : m.rows) {
    const auto polyline = base::row_of(row.evaluator).polyline;
    double& worst = row.cells[column].worst_error;
    for (std::size_t i = m.searched; i < end; ++i) {
      polyline(m.curves[i], points, {});
      worst = std::max(worst, deviation_of(m.curves[i].cubic, points));
    }
  }
  m.searched = end;
  return end == m.curves.size();
}

}  // namespace

Measurement start_measurement(const DerivedTrack& derived) {
  Measurement m;
  if (derived.order.empty()) return m;
  for (const world::Entity segment : derived.order) m.curves.push_back(derived.shape(segment).curve);
  for (std::size_t i = 0; i < curve::evaluators().size(); ++i)
    m.rows.push_back({static_cast<curve::EvaluatorId>(i), {}, {}});
  m.total = kMeasureRounds * static_cast<int>(kMeasuredSteps.size());
  for (const int steps : kMeasuredSteps) m.total += static_cast<int>((m.curves.size() - 1) / searched_at_once(steps));
  m.running = true;
  return m;
}

void measure_next(Measurement& m, const Clock& clock) {
  if (!m.running) return;
  const TimingPass share = share_of(m.timed);
  std::vector<glm::vec3> points(static_cast<std::size_t>(kMeasuredSteps[share.column]) + 1);
  // The search for errors also warms up every row's code and data.
  if (share.round > 0 || find_errors(m, share.column, points)) {
    for (std::size_t i = 0; i < m.rows.size(); ++i)
      time_row(m, m.rows[(i + static_cast<std::size_t>(share.round)) % m.rows.size()], share, points, clock);
    ++m.timed, m.searched = 0;
  }
  ++m.next;
  m.running = m.next < m.total;
}

double progress(const Measurement& m) { return m.total == 0 ? 0.0 : static_cast<double>(m.next) / m.total; }

const MeasuredRow* row_of(const Measurement& m, curve::EvaluatorId evaluator) {
  const auto found = std::ranges::find(m.rows, evaluator, &MeasuredRow::evaluator);
  return found == m.rows.end() ? nullptr : &*found;
}

std::string to_csv(const Measurement& m, std::string_view machine) {
  std::string csv = fmt::format("# {}\r\nevaluator,steps,ns_per_point,worst_error_m,rounds\r\n", machine);
  for (const MeasuredRow& row : m.rows)
    for (std::size_t column = 0; column < kMeasuredSteps.size(); ++column) {
      const MeasuredCell& cell = row.cells[column];
      if (cell.rounds == 0) continue;
      csv += fmt::format("{},{},{},{:.4g},{}\r\n", base::name_of(row.evaluator), kMeasuredSteps[column],
                         row.is_timed() ? fmt::format("{:.4g}", cell.ns_per_point) : "", cell.worst_error, cell.rounds);
    }
  return csv;
}

// --- Rounding errors of a polyline

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
