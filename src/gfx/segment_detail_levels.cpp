#include "gfx/segment_detail_levels.h"

#include <algorithm>
#include <limits>

namespace coaster::gfx {
namespace {

constexpr float kEyeStep = 16;  // m
constexpr float kEyeOff = 14;   // m, largest distance of the eye from the nearest step

// Returns the vertices of a polyline, with the break at its end.
std::int64_t vertices(int lines) { return lines + 2; }

float nearest(const LevelView& sight, const SegmentSize& size) {
  return std::max(0.0f, glm::distance(sight.eye, size.middle) - size.radius - kEyeOff);
}

bool needs_steps(const SegmentSize& size, int far_lines, float off_at_nearest) {
  const float lines = static_cast<float>(far_lines);
  return size.bend / (8 * lines * lines) > off_at_nearest;
}

}  // namespace

SegmentSize size_of(const curve::Cubic& cubic) {
  const curve::Box box = curve::control_box(cubic);
  const glm::vec3 from = cubic.p0 - 2.0f * cubic.p1 + cubic.p2, to = cubic.p1 - 2.0f * cubic.p2 + cubic.p3;
  return {0.5f * box.low + 0.5f * box.high, 0.5f * glm::distance(box.low, box.high),
          6 * std::max(glm::length(from), glm::length(to))};
}

int SegmentLevels::lines_of(const SegmentSize& size) const {
  return far_lines == steps || needs_steps(size, far_lines, line_off * nearest(sight, size)) ? steps : far_lines;
}

bool SegmentLevels::solid(const SegmentSize& size) const {
  if (all_solid) return true;
  const float metres = nearest(sight, size);
  return metres <= sight.reach || size.bend / 8 > sight.off * metres;
}

LevelView in_steps(LevelView sight) {
  sight.eye = kEyeStep * glm::round(sight.eye / kEyeStep);
  return sight;
}

std::size_t LevelChoice::doublings_of(const SegmentSize& size) const {
  const float metres = nearest(levels_.sight, size);
  float off = levels_.sight.off;
  std::size_t doublings = 0;
  for (; doublings < kMostDoublings && needs_steps(size, levels_.far_lines, off * metres); off *= 2) ++doublings;
  return doublings;
}

void LevelChoice::begin(std::span<const SegmentSize> sizes, int steps, const LevelView& sight) {
  segments_ = static_cast<std::int64_t>(sizes.size());
  levels_ = {steps, steps, 0, sizes.size() <= kMostSolids, in_steps(sight)};
  all_lines_ = segments_ * vertices(steps) <= kPolylineBudget;
  if (all_lines_) return;
  levels_.far_lines = 1;
  while (2 * levels_.far_lines < steps && segments_ * vertices(2 * levels_.far_lines) <= kPolylineBudget / 2)
    levels_.far_lines *= 2;
  needing_ = {};
  for (const SegmentSize& size : sizes) ++needing_[doublings_of(size)];
}

void LevelChoice::replace(const SegmentSize& before, const SegmentSize& now) {
  if (all_lines_) return;
  --needing_[doublings_of(before)], ++needing_[doublings_of(now)];
}

SegmentLevels LevelChoice::levels() const {
  SegmentLevels levels = levels_;
  if (!all_lines_) {
    levels.line_off = std::numeric_limits<float>::infinity();
    float off = levels.sight.off;
    std::int64_t fine = segments_;
    for (std::size_t i = 0; i < kMostDoublings; ++i, off *= 2) {
      fine -= needing_[i];
      if (fine * vertices(levels.steps) + (segments_ - fine) * vertices(levels.far_lines) > kPolylineBudget) continue;
      levels.line_off = off;
      break;
    }
  }
  if (levels.all()) levels.sight = {};  // independent of the eye
  return levels;
}

}  // namespace coaster::gfx
