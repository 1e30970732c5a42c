#include "sim/shape/detail_limits.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "base/text.h"

namespace coaster::sim {

SolidsDetail detail_of(const DerivedTrack& derived) {
  SolidsDetail detail;
  detail.parts = derived.length <= kMaxDetailedLength;
  const std::size_t segments = derived.order.size();
  while (static_cast<std::size_t>(detail.most_rings) * segments > kMaxAllRings && detail.most_rings > 2)
    detail.most_rings = std::max(2, detail.most_rings / 2);
  if (static_cast<std::size_t>(detail.most_rings) * segments > kMaxAllRings) detail.most_rings = 0;
  detail.parts = detail.parts && detail.most_rings > 0;
  while (derived.length / detail.table_step > kMaxTableEntries) detail.table_step *= 2;
  return detail;
}

std::string detail_text(const SolidsDetail& detail) {
  std::string text;
  if (detail.most_rings == 0) text = "The track is drawn as a curve alone.";
  else if (!detail.parts) text = "Ties, equipment and supports are drawn only near the eye.";
  if (detail.table_step > kTableStep)
    text += fmt::format("{}Forces are computed every {} m.", text.empty() ? "" : " ", base::to_text(detail.table_step));
  return text.empty() ? text : "This is a very long track. " + text;
}

namespace {

constexpr float kEyeStep = 16;  // m
constexpr float kEyeOff = 14;   // m, how far the eye is from the nearest step at most

}  // namespace

void NearSegments::look_from(const EyeSurroundings& around) {
  const EyeSurroundings stepped{kEyeStep * glm::round(around.eye / kEyeStep), around.reach};
  stale_ = stale_ || !(stepped == around_);
  around_ = stepped;
}

void NearSegments::update(const DerivedTrack& derived) {
  if (!std::exchange(stale_, false) && build_ == derived.last_build) return;
  build_ = derived.last_build;
  everywhere_ = derived.order.size() <= kMostFitted && derived.length <= kMaxNearLength && detail_of(derived).parts;
  indices_.clear();
  if (everywhere_ || !(around_.reach > 0) || detail_of(derived).most_rings == 0) return;
  constexpr float kLeastReach = 4;  // m
  for (float reach = around_.reach; reach > kLeastReach && !gather(derived, reach); reach *= 0.75f) indices_.clear();
  std::sort(indices_.begin(), indices_.end());
}

// Returns false if more is within reach than may be near.
bool NearSegments::gather(const DerivedTrack& derived, float reach) {
  const float most = reach + kEyeOff;
  const curve::Box box{around_.eye - most, around_.eye + most};
  double length = 0;
  return all_near(derived.tree, box, [&](std::size_t i) {
    const curve::Box own = curve::control_box(derived.tree.cubics[i]);
    const glm::vec3 off = glm::max(glm::max(own.low - around_.eye, around_.eye - own.high), glm::vec3(0));
    if (glm::length(off) > most) return true;
    length += derived.starts[i + 1] - derived.starts[i];
    indices_.push_back(i);
    return length <= kMaxNearLength && indices_.size() <= kMostFitted;
  });
}

SolidsDetail NearSegments::detail(SolidsDetail detail) const {
  if (everywhere_ || indices_.empty()) return detail;
  detail.parts = true;
  detail.most_rings = std::max(detail.most_rings, kNearRings);
  return detail;
}

}  // namespace coaster::sim
