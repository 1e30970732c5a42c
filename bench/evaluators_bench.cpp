// Time a point of every row of the evaluator table, beside a plain store of the same bytes. Each prints a checksum, so work cannot vanish.
#include <benchmark/benchmark.h>

#include <cstring>
#include <random>
#include <string>
#include <vector>

#include "curve/arc_length.h"
#include "curve/evaluators.h"

namespace coaster {
namespace {

constexpr int kSegments = 1000, kSteps = 64;

std::vector<curve::PreparedCubic> cubics() {
  std::mt19937 random(7);
  std::uniform_real_distribution<float> place(-80, 80), bend(-6, 6);
  std::vector<curve::PreparedCubic> all;
  for (int i = 0; i < kSegments; ++i) {
    const glm::vec3 p(place(random), place(random), place(random)), d(bend(random) + 10, bend(random), bend(random));
    const glm::vec3 e(bend(random) + 10, bend(random), bend(random));
    all.push_back(curve::prepare({p, p + d / 3.0f, p + d - e / 3.0f, p + d}));
  }
  return all;
}

double checksum(const std::vector<glm::vec3>& points) {
  double sum = 0;
  for (const glm::vec3 p : points) sum += p.x + 2.0 * p.y + 3.0 * p.z;
  return sum;
}

void evaluator_points(benchmark::State& state, const curve::Evaluator& row, bool tangents) {
  const auto all = cubics();
  std::vector<glm::vec3> points((kSteps + 1) * kSegments), directions(tangents ? points.size() : 0);
  for (auto _ : state) {
    for (int i = 0; i < kSegments; ++i) {
      const std::size_t first = static_cast<std::size_t>(i) * (kSteps + 1);
      row.polyline(all[static_cast<std::size_t>(i)], std::span(points).subspan(first, kSteps + 1),
                   tangents ? std::span(directions).subspan(first, kSteps + 1) : std::span<glm::vec3>());
    }
    benchmark::ClobberMemory();
  }
  state.counters["ns_per_point"] =
      benchmark::Counter(static_cast<double>(points.size()) * 1e-9, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
  state.counters["checksum"] = checksum(points);
}

void store(benchmark::State& state) {
  std::vector<glm::vec3> points((kSteps + 1) * kSegments);
  int value = 1;
  for (auto _ : state) {
    std::memset(points.data(), value++ & 0x3f, points.size() * sizeof(glm::vec3));
    benchmark::ClobberMemory();
  }
  state.counters["ns_per_point"] =
      benchmark::Counter(static_cast<double>(points.size()) * 1e-9, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
  state.counters["checksum"] = checksum(points);
}

void arc_length_rows(benchmark::State& state, const curve::ArcLengthMethod& row) {
  const auto all = cubics();
  double sum = 0;
  for (auto _ : state) {
    sum = 0;
    for (const curve::PreparedCubic& c : all) sum += row.length(c.cubic, kSteps);
    benchmark::DoNotOptimize(sum);
  }
  state.counters["ns_per_segment"] =
      benchmark::Counter(kSegments * 1e-9, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
  state.counters["checksum"] = sum;
}

[[maybe_unused]] const bool registered = [] {
  benchmark::RegisterBenchmark("evaluate/store", store);
  for (const curve::Evaluator& row : curve::evaluators()) {
    benchmark::RegisterBenchmark(("evaluate/points/" + std::string(row.name)).c_str(), evaluator_points, row, false);
    benchmark::RegisterBenchmark(("evaluate/points_and_tangents/" + std::string(row.name)).c_str(), evaluator_points, row, true);
  }
  for (const curve::ArcLengthMethod& row : curve::arc_length_methods())
    benchmark::RegisterBenchmark(("arc_length/" + std::string(row.name)).c_str(), arc_length_rows, row);
  return true;
}();

}  // namespace
}  // namespace coaster
