#include "curve/frames_batch.h"

#include "base/check.h"
#include "curve/kernels_jobs.h"

namespace coaster::curve {
namespace {

static_assert(sizeof(glm::dvec3) == 3 * sizeof(double), "the kernels read a vector as 3 doubles");

using Places = std::span<const glm::dvec3>;

void one_chain(Places points, Places tangents, std::span<glm::dvec3> ups) {
  for (std::size_t i = 1; i < points.size(); ++i)
    ups[i] = transport({tangents[i - 1], ups[i - 1]}, points[i - 1], points[i], tangents[i]).up;
}

void eight_chains(Processor on, const detail::FrameJob& job) {
#ifdef COASTER_AVX2_KERNELS
  if (on == Processor::avx2) return detail::transport_eight_avx2(job);
#endif
  (void)on;
  detail::transport_eight_baseline(job);
}

}  // namespace

void transport_chains(int count, Places points, Places tangents, std::span<glm::dvec3> ups, Processor on) {
  COASTER_CHECK(count >= 1 && points.size() % static_cast<std::size_t>(count) == 0, "points are whole chains");
  COASTER_CHECK(tangents.size() == points.size() && ups.size() == points.size(), "one tangent and one up per point");
  const auto n = static_cast<std::size_t>(count);
  const std::size_t chains = points.size() / n;
  const auto alone = [&](std::size_t c) {
    one_chain(points.subspan(c * n, n), tangents.subspan(c * n, n), ups.subspan(c * n, n));
  };
  std::size_t c = 0;
  for (; c + 8 <= chains; c += 8) {
    bool bad[8] = {};
    eight_chains(on, {&points[c * n].x, &tangents[c * n].x, &ups[c * n].x, count, bad});
    for (std::size_t l = 0; l < 8; ++l)
      if (bad[l]) alone(c + l);
  }
  for (; c < chains; ++c) alone(c);
}

}  // namespace coaster::curve
