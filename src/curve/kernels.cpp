// Chooses the kernels for the processor, passes them plain memory, and computes the remaining vertices in double.
#include "curve/kernels.h"

#include <array>
#include <cstdint>

#include "base/check.h"
#include "curve/kernels_jobs.h"

namespace coaster::curve {
namespace {

static_assert(sizeof(PreparedCubic) == 24 * sizeof(float), "the kernels read a prepared cubic as 24 floats");

constexpr std::array<InstructionSet, 2> kProcessors{InstructionSet::baseline, InstructionSet::avx2};

InstructionSet find_best() {
#ifdef COASTER_AVX2_KERNELS
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) return InstructionSet::avx2;
#endif
  return InstructionSet::baseline;
}

const detail::Kernels& kernels([[maybe_unused]] InstructionSet on) {
#ifdef COASTER_AVX2_KERNELS
  if (on == InstructionSet::avx2) return detail::avx2_kernels();
#endif
  return detail::baseline_kernels();
}

const float* floats(std::span<const PreparedCubic> curves) { return reinterpret_cast<const float*>(curves.data()); }

// Larger than the last-level cache of most processors: written data would evict everything else and then be evicted
// itself.
constexpr std::size_t kPastTheCaches = std::size_t{32} << 20;

bool may_stream(std::span<const glm::vec3> out, int points) {
  return out.size_bytes() > kPastTheCaches && points % 8 == 0 && reinterpret_cast<std::uintptr_t>(out.data()) % 32 == 0;
}

}  // namespace

InstructionSet best_processor() {
  static const InstructionSet best = find_best();
  return best;
}

std::span<const InstructionSet> available_processors() {
  return std::span(kProcessors).first(best_processor() == InstructionSet::avx2 ? 2 : 1);
}

// As Horner's bound in evaluators.cpp (M + 120 S for coefficients and five operations below 13 S), plus the scaling by
// powers of 1/n: at most 6 u of coefficients below 13 S. A fused multiply-add rounds once less.
double vector_horner_error_bound(double extent, double size) { return (extent + 200.0 * size) / (1 << 24); }

// A run of 64 vertices, with S the polygon's length and h = 8/n (at most 8 steps of at most 1/8, as a run covers at
// most the curve): first <= 6 S h, second <= 24 S h^2, third <= 24 S h^3. One rounding per step each, and values below
// 7 S as well, sum to below 8 * 7 S + 8 * 6 S h + 28 * 24 S h^2 <= 73 S for h = 1/8. Relative errors of 12 u in the
// start values of all three (scaling, shift, tables of exact numbers) grow to at most 12 (3 + 6 + 4) S = 156 S, and
// Horner's start has its 200 S. The run's first point and the sum with it round at M once each.
double vector_differences_error_bound(double extent, double size) { return (2.0 * extent + 430.0 * size) / (1 << 24); }

// The same with the first point inside the value: each of seven additions also rounds at M.
double track_error_bound(double extent, double size) { return (9.0 * extent + 430.0 * size) / (1 << 24); }

void vector_polyline(VectorMethod method, const PreparedCubic& curve, std::span<glm::vec3> points, InstructionSet on) {
  COASTER_CHECK(points.size() >= 2, "a polyline has at least one step");
  const int n = static_cast<int>(points.size()) - 1;
  const detail::KernelJob job{floats({&curve, 1}), 1, n, n + 1, &points[0].x};
  const detail::Kernels& k = kernels(on);
  (method == VectorMethod::horner ? k.positions_by_horner : k.positions_by_differences)(job);
}

std::size_t track_vertices(std::size_t curves, int steps, VertexLayout layout) {
  if (curves == 0) return 0;
  const auto n = static_cast<std::size_t>(steps);
  return layout == VertexLayout::polylines ? curves * (n + 1) : curves * n + 1;
}

void track_points(std::span<const PreparedCubic> curves, int steps, VertexLayout layout, std::span<glm::vec3> out,
                  InstructionSet on) {
  COASTER_CHECK(steps >= 1 && out.size() == track_vertices(curves.size(), steps, layout),
                "`out` has the size of the layout");
  if (curves.empty()) return;
  const int points = layout == VertexLayout::polylines ? steps + 1 : steps;
  const detail::KernelJob job{floats(curves), curves.size(), steps, points, &out[0].x};
  const detail::Kernels& k = kernels(on);
  (may_stream(out, points) ? k.track_positions_streamed : k.track_positions)(job);
  if (layout == VertexLayout::chain) out.back() = curves.back().cubic.p3;
}

}  // namespace coaster::curve
