// How far the vertices that a shader stage computes are from the exact points: captured from the GPU itself, compared
// on the processor.
#pragma once

#include <cstdint>
#include <vector>

#include "gfx/curve_stages.h"
#include "gfx/track_cache.h"

namespace coaster::gfx {

class CurveDeviation {
 public:
  explicit CurveDeviation(const Gl& gl) : gl_(&gl), buffer_(make_buffer(gl)) {}

  struct Result {
    double metres =
        0;  // the largest |vertex - exact point at the same t| (long double oracle) of the segments measured so far
    int pending = 0;  // segments still to be measured; all of them where the driver cannot
  };
  // Measures segments that were not measured by this stage, shape and resolution yet, up to kBudget vertices a call
  // (one segment at least), and waits for the GPU to do so. A call after which nothing changed costs a comparison for
  // each segment.
  Result update(CurveStages& stages, curve::Stage stage, const TrackCache& track, const sim::Derived& derived);
  static constexpr int kBudget = 32'768;

 private:
  struct Known {
    TrackCache::Placed placed;
    double metres = 0;
  };
  bool measure(CurveStages& stages, const CurveSlots& slots, const sim::Derived& derived,
               std::span<const TrackCache::Placed> placed);

  const Gl* gl_;
  Object buffer_;
  std::size_t capacity_ = 0;  // bytes
  curve::Stage stage_{};
  int steps_ = 0;
  bool able_ = true;
  std::vector<Known> known_;  // by slot
  std::vector<CurveStages::Captured> records_;
};

}  // namespace coaster::gfx
