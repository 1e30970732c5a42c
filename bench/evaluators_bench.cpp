// Time and error per point of every evaluator, and of whole tracks by the vector kernels, relative to a store of the
// same bytes. ratio_to_store: time / time of the store (1 is the limit); ratio_to_forward_differences: speed-up over
// the scalar loop.
#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <memory>

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

#include "base/enum_names.h"
#include "bench_tracks.h"
#include "curve/evaluators.h"
#include "curve/kernels.h"
#include "paired.h"

namespace coaster::bench {
namespace evaluators_bench {

constexpr std::size_t kSegments = 1000, kManySegments = 100'000;
constexpr int kSteps = 64;

// Aligned like a mapped vertex buffer.
template <class T>
class Buffer {
 public:
  explicit Buffer(std::size_t count)
      : memory_(static_cast<T*>(std::aligned_alloc(64, (count * sizeof(T) + 63) / 64 * 64)), &std::free),
        items_(memory_.get(), count) {
    std::memset(static_cast<void*>(memory_.get()), 1, items_.size_bytes());  // touches every page
  }
  std::span<T> items() const { return items_; }

 private:
  std::unique_ptr<T, decltype(&std::free)> memory_;
  std::span<T> items_;
};

void plain_store(void* to, std::size_t bytes) {
  static int value = 1;
  std::memset(to, value++ & 0x3f, bytes);
}

void non_temporal_store(void* to, std::size_t bytes) {
#if defined(__SSE2__)
  static int value = 1;
  const __m128i what = _mm_set1_epi32(value++);
  auto* p = static_cast<__m128i*>(to);
  for (std::size_t i = 0; i < bytes / 16; ++i) _mm_stream_si128(p + i, what);
  _mm_sfence();
#else
  plain_store(to, bytes);
#endif
}

// Writes the polylines of all curves, one after the other, n + 1 vertices each.
void polylines(const curve::Evaluator& row, std::span<const curve::PreparedCubic> all, int steps,
               std::span<glm::vec3> points, std::span<glm::vec3> tangents) {
  const std::size_t n = static_cast<std::size_t>(steps) + 1;
  for (std::size_t i = 0; i < all.size(); ++i)
    row.polyline(all[i], points.subspan(i * n, n), tangents.empty() ? tangents : tangents.subspan(i * n, n));
}

const curve::Evaluator& forward_differences() {
  return base::row_of(*base::value_named<curve::EvaluatorId>("forward_differences"));
}

double worst_error(const curve::Evaluator& row, std::span<const curve::PreparedCubic> all, int steps) {
  std::vector<glm::vec3> points(static_cast<std::size_t>(steps) + 1);
  double worst = 0;
  for (const curve::PreparedCubic& c : all) {
    row.polyline(c, points, {});
    for (int i = 0; i <= steps; ++i)
      worst = std::max(worst, glm::length(glm::dvec3(points[static_cast<std::size_t>(i)]) -
                                          curve::point_long_double(c.cubic, static_cast<double>(i) / steps)));
  }
  return worst;
}

void evaluate(benchmark::State& state, const curve::Evaluator& row, bool with_tangents) {
  const auto all = track_cubics(kSegments);
  const Buffer<glm::vec3> points(kSegments * (kSteps + 1)), tangents(kSegments * (kSteps + 1));
  const auto to = points.items(), along = with_tangents ? tangents.items() : std::span<glm::vec3>();
  paired(state, "point", static_cast<double>(to.size()), [&] { polylines(row, all, kSteps, to, along); },
         {{"ratio_to_store",
           [&] { plain_store(to.data(), to.size_bytes()), plain_store(along.data(), along.size_bytes()); }},
          {"ratio_to_forward_differences", [&] { polylines(forward_differences(), all, kSteps, to, along); }, false}});
  state.counters["checksum"] = checksum(to.data(), to.size());
}

// For the plot of time against error: the same number of vertices for every number of steps.
void accuracy(benchmark::State& state, const curve::Evaluator& row) {
  const int steps = static_cast<int>(state.range(0));
  const auto all = track_cubics(std::max<std::size_t>(1, 65536 / static_cast<std::size_t>(steps)));
  const Buffer<glm::vec3> points(all.size() * (static_cast<std::size_t>(steps) + 1));
  paired(state, "point", static_cast<double>(points.items().size()),
         [&] { polylines(row, all, steps, points.items(), {}); },
         {{"ratio_to_store", [&] { plain_store(points.items().data(), points.items().size_bytes()); }}});
  state.counters["worst_error_m"] = worst_error(row, track_cubics(256), steps);
  state.counters["checksum"] = checksum(points.items().data(), points.items().size());
}

void track_points(benchmark::State& state, curve::InstructionSet on, std::size_t segments, bool past_caches) {
  const auto all = track_cubics(segments);
  const Buffer<glm::vec3> out(curve::track_vertices(segments, kSteps, curve::VertexLayout::chain));
  const auto to = out.items();
  const Work store = [&] {
    past_caches ? non_temporal_store(to.data(), to.size_bytes()) : plain_store(to.data(), to.size_bytes());
  };
  std::vector<Reference> references{{past_caches ? "ratio_to_non_temporal_store" : "ratio_to_store", store}};
  const Buffer<glm::vec3> scalar(past_caches ? 1 : segments * (kSteps + 1));
  if (!past_caches)
    references.push_back({"ratio_to_forward_differences",
                          [&] { polylines(forward_differences(), all, kSteps, scalar.items(), {}); }, false});
  paired(
      state, "point", static_cast<double>(to.size()),
      [&] { curve::track_points(all, kSteps, curve::VertexLayout::chain, to, on); }, references);
  state.counters["checksum"] = checksum(to.data(), to.size());
}

void store(benchmark::State& state, std::size_t bytes, bool past_caches) {
  const Buffer<char> to(bytes);
  paired(state, "point", static_cast<double>(bytes) / 12,
         [&] { past_caches ? non_temporal_store(to.items().data(), bytes) : plain_store(to.items().data(), bytes); },
         {});
}

template <class Run, class... Rest>
benchmark::internal::Benchmark* add(const std::string& name, Run run, Rest... rest) {
  return benchmark::RegisterBenchmark(name.c_str(), [=](benchmark::State& state) { run(state, rest...); })
      ->UseManualTime();
}

[[maybe_unused]] const bool registered = [] {
  add("store/positions", store, kSegments * kSteps * 12, false);
  add("store/non_temporal", store, kManySegments * kSteps * 12, true);
  for (const curve::Evaluator& row : curve::evaluators()) {
    if (row.evaluated_by != curve::EvaluatedBy::processor) continue;  // their processor twin is Horner's row
    const std::string name(row.name);
    add("evaluate/points/" + name, evaluate, row, false);
    add("evaluate/points_and_tangents/" + name, evaluate, row, true);
    add("accuracy/" + name, accuracy, row)->Arg(16)->Arg(64)->Arg(256)->Arg(1024)->Arg(4096);
  }
  for (const curve::InstructionSet on : curve::available_processors()) {
    const std::string path = on == curve::InstructionSet::avx2 ? "avx2" : "baseline";
    add("track/points/" + path, track_points, on, kSegments, false);
    add("track/points_past_caches/" + path, track_points, on, kManySegments, true);
  }
  return true;
}();

}  // namespace evaluators_bench
}  // namespace coaster::bench
