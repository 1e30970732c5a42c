// Rotation-minimising frames of 1000 segments, 33 each: eight chains at once beside the loop over transport().
// ratio_to_scalar: speed-up.
#include "bench_tracks.h"
#include "curve/frames_batch.h"
#include "paired.h"

namespace coaster::bench {
namespace {

constexpr int kPlaces = 33;

void frames(benchmark::State& state, curve::Processor on) {
  std::vector<glm::dvec3> points, tangents, ups;
  for (const curve::PreparedCubic& c : track_cubics(1000))
    for (int i = 0; i < kPlaces; ++i) {
      points.push_back(curve::point(c.cubic, i / (kPlaces - 1.0)));
      tangents.push_back(curve::unit_tangent(c.cubic, i / (kPlaces - 1.0)));
      ups.push_back(i == 0 ? curve::perpendicular(tangents.back(), {0, 1, 0}) : glm::dvec3(0));
    }
  const Work scalar = [&] {
    for (std::size_t i = 0; i < ups.size(); ++i)
      if (i % kPlaces != 0)
        ups[i] = curve::transport({tangents[i - 1], ups[i - 1]}, points[i - 1], points[i], tangents[i]).up;
  };
  paired(state, "frame", static_cast<double>(ups.size()),
         [&] { curve::transport_chains(kPlaces, points, tangents, ups, on); }, {{"ratio_to_scalar", scalar, false}});
  double sum = 0;
  for (const glm::dvec3 up : ups) sum += up.x + 2 * up.y + 3 * up.z;
  state.counters["checksum"] = sum;
}

[[maybe_unused]] const bool registered = [] {
  for (const curve::Processor on : curve::available_processors())
    benchmark::RegisterBenchmark(on == curve::Processor::avx2 ? "frames/avx2" : "frames/baseline",
                                 [on](benchmark::State& state) { frames(state, on); })
        ->UseManualTime();
  return true;
}();

}  // namespace
}  // namespace coaster::bench
