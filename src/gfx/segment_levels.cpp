#include "gfx/segment_levels.h"

#include <algorithm>
#include <limits>

namespace coaster::gfx {
namespace {

constexpr float kEyeStep = 16;  // m
constexpr float kEyeOff = 14;   // m, how far the eye is from the nearest step at most

// Vertices of a polyline, with the break at its end.
std::int64_t vertices(int lines) { return lines + 2; }

float nearest(const Sight& sight, const SegmentSize& size) {
  return std::max(0.0f, glm::distance(sight.eye, size.middle) - size.radius - kEyeOff);
}

void choose_lines(std::span<const SegmentSize> sizes, SegmentLevels& levels) {
  const auto count = static_cast<std::int64_t>(sizes.size());
  if (count * vertices(levels.steps) <= kPolylineBudget) return;
  levels.far_lines = 1;
  while (2 * levels.far_lines < levels.steps && count * vertices(2 * levels.far_lines) <= kPolylineBudget / 2)
    levels.far_lines *= 2;
  levels.line_off = levels.sight.off;
  constexpr int kMostDoublings = 24;
  for (int i = 0;; ++i, levels.line_off *= 2) {
    if (i == kMostDoublings) levels.line_off = std::numeric_limits<float>::infinity();
    std::int64_t sum = 0;
    for (const SegmentSize& size : sizes) sum += vertices(levels.lines_of(size));
    if (sum <= kPolylineBudget || i == kMostDoublings) return;
  }
}

}  // namespace

SegmentSize size_of(const curve::Cubic& cubic) {
  const curve::Box box = curve::control_box(cubic);
  const glm::vec3 from = cubic.p0 - 2.0f * cubic.p1 + cubic.p2, to = cubic.p1 - 2.0f * cubic.p2 + cubic.p3;
  return {0.5f * box.low + 0.5f * box.high, 0.5f * glm::distance(box.low, box.high),
          6 * std::max(glm::length(from), glm::length(to))};
}

int SegmentLevels::lines_of(const SegmentSize& size) const {
  if (far_lines == steps) return steps;
  const float lines = static_cast<float>(far_lines);
  return size.bend / (8 * lines * lines) > line_off * nearest(sight, size) ? steps : far_lines;
}

bool SegmentLevels::solid(const SegmentSize& size) const {
  if (all_solid) return true;
  const float metres = nearest(sight, size);
  return metres <= sight.reach || size.bend / 8 > sight.off * metres;
}

SegmentLevels choose_levels(std::span<const SegmentSize> sizes, int steps, const Sight& sight) {
  SegmentLevels levels{steps, steps, 0, sizes.size() <= kMostSolids, sight};
  levels.sight.eye = kEyeStep * glm::round(sight.eye / kEyeStep);
  choose_lines(sizes, levels);
  if (levels.all()) levels.sight = {};  // wherever the eye is
  return levels;
}

}  // namespace coaster::gfx
