// The level of detail of the segments of a very long track on the GPU: full near the eye, coarse where the difference
// is invisible. Pure functions, no GL.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include <glm/glm.hpp>

#include "curve/cubic.h"
#include "sim/shape/detail_limits.h"

namespace coaster::gfx {

// The largest number of vertices of polylines on the GPU, if fewer lines suffice: 36 MB, and as many lines of two
// triangles each. Up to here all polylines have all of their steps.
inline constexpr std::int64_t kPolylineBudget = 1'500'000;
// On tracks of more segments, rails and spine of a far one are a single straight piece.
inline constexpr std::size_t kMostSolids = sim::kMostFitted;

// The properties of a segment that its level depends on.
struct SegmentSize {
  glm::vec3 middle{0};
  float radius = 0;  // m, of a sphere around the middle that contains the curve
  float bend = 0;    // m, the largest |B''(t)|: n equal chords are off by at most bend / (8 n^2)
};
SegmentSize size_of(const curve::Cubic& cubic);

// The view that levels depend on.
struct LevelView {
  glm::vec3 eye{0};
  float off = 0;    // m per metre of distance: smaller deviations are invisible
  float reach = 0;  // m, up to which even straight rails are held in full
  friend bool operator==(const LevelView&, const LevelView&) = default;
};

struct SegmentLevels {
  int steps = 0, far_lines = 0;  // lines of a near and of a far polyline; equal if all fit
  float line_off = 0;            // largest deviation of a far polyline, in metres per metre of distance
  bool all_solid = true;         // all rails are held in full
  LevelView sight;               // of an eye that moves in steps of some metres
  int lines_of(const SegmentSize& size) const;
  bool solid(const SegmentSize& size) const;
  bool all() const { return all_solid && far_lines == steps; }
  friend bool operator==(const SegmentLevels&, const SegmentLevels&) = default;
};

// Returns the sight of an eye that moves in steps of some metres.
LevelView in_steps(LevelView sight);

// Chooses the levels for segments with polylines of `steps` steps. If not all visible lines fit, line_off is sight.off
// times a power of two. Depends only on in_steps(sight).
class LevelChoice {
 public:
  // Counts all segments.
  void begin(std::span<const SegmentSize> sizes, int steps, const LevelView& sight);
  // Counts a segment whose size changed.
  void replace(const SegmentSize& before, const SegmentSize& now);
  SegmentLevels levels() const;

 private:
  static constexpr std::size_t kMostDoublings = 24;
  std::size_t doublings_of(const SegmentSize& size) const;

  SegmentLevels levels_;  // without line_off
  bool all_lines_ = true;
  std::int64_t segments_ = 0;
  // Number of segments that need all their steps unless line_off is sight.off doubled that often, or more.
  std::array<std::int64_t, kMostDoublings + 1> needing_{};
};

}  // namespace coaster::gfx
