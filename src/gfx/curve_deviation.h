// The deviation of vertices computed by a shader stage from the exact points: captured from the GPU, compared on the
// processor.
#pragma once

#include <vector>

#include "gfx/gpu_curves.h"
#include "gfx/track_cache.h"

namespace coaster::gfx {

class CurveDeviation {
 public:
  explicit CurveDeviation(const Gl& gl) : gl_(&gl), buffer_(make_buffer(gl)) {}

  struct Result {
    double metres = 0;  // m, the largest |vertex - exact point at the same t| (long double) of the measured segments
    int pending = 0;    // segments not yet measured; all of them if the driver cannot capture
  };
  // Measures segments that have not been measured with this stage, shape and resolution, up to kBudget vertices per
  // call (at least one segment), and waits for the GPU. If nothing changed, a call costs one comparison per segment.
  Result update(GpuCurves& curves, curve::EvaluatedBy stage, const TrackCache& track, const sim::Derived& derived);
  static constexpr int kBudget = 32'768;

 private:
  struct Known {
    TrackCache::Placed placed;
    double metres = 0;
  };
  bool read(GpuCurves& curves, const CurveSlots& slots);
  bool measure(GpuCurves& curves, const CurveSlots& slots, const sim::Derived& derived,
               std::span<const TrackCache::Placed> placed);

  const Gl* gl_;
  Object buffer_;
  curve::EvaluatedBy stage_{};
  int steps_ = 0;
  bool able_ = true;
  std::vector<Known> known_;  // by slot
  std::vector<GpuCurves::Captured> records_;
};

}  // namespace coaster::gfx
