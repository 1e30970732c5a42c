#include "gfx/shadow_fit.h"

#include <algorithm>
#include <cmath>

#include <glm/gtc/matrix_transform.hpp>

#include "sim/solids/supports.h"

namespace coaster::gfx {
namespace {

constexpr float kTrackMargin = sim::kSupportReach + 1, kCarMargin = 2.5f;  // m
constexpr float kDepthMargin = 1;                                          // m
constexpr float kLargest = 1 << 18;                                        // m, more than the world's width

// Returns the distance from a point to a box; 0 inside.
float distance_to(const LightBox& box, glm::vec3 at) {
  return glm::length(glm::max(glm::max(box.low - at, at - box.high), glm::vec3(0)));
}

float power_of_two(float least, float wanted) {
  float side = least;
  while (side < wanted && side < kLargest) side *= 2;
  return side;
}

constexpr std::size_t kRun = 64;  // segments

LightBox box_of(const SunAxes& axes, const sim::SegmentShape& shape) {
  LightBox box;
  const curve::Cubic& c = shape.key.cubic;
  const float margin = kTrackMargin + static_cast<float>(std::abs(shape.key.rails));
  for (const glm::vec3 p : {c.p0, c.p1, c.p2, c.p3}) {
    box.add(axes.of(p), margin);
    box.add(axes.of({p.x, 0, p.z}), margin);
  }
  return box;
}

LightBox both(const LightBox& a, const LightBox& b) { return {glm::min(a.low, b.low), glm::max(a.high, b.high)}; }

}  // namespace

SunAxes::SunAxes(glm::vec3 towards_sun) : sun(glm::normalize(towards_sun)) {
  const glm::vec3 level = glm::cross(glm::vec3(0, 1, 0), sun);
  across = glm::length(level) > 1e-4f ? glm::normalize(level) : glm::vec3(1, 0, 0);
  over = glm::cross(sun, across);
}

void LightBox::add(glm::vec3 light, float margin) {
  low = glm::min(low, light - margin);
  high = glm::max(high, light + margin);
}

const LightBox& TrackBox::update(const SunAxes& axes, const sim::Derived& derived) {
  looked_at_ = 0;
  std::vector<std::size_t> stale;
  const auto changes = sun_ == axes.sun ? derived.changes_since(last_build_) : std::nullopt;
  if (changes) {
    for (const sim::ShapeChange& change : *changes)
      if (const std::size_t run = change.index / kRun; stale.empty() || stale.back() != run) stale.push_back(run);
  } else {
    runs_.resize((derived.order.size() + kRun - 1) / kRun);
    for (std::size_t run = 0; run < runs_.size(); ++run) stale.push_back(run);
  }
  sun_ = axes.sun, last_build_ = derived.last_build;
  for (const std::size_t run : stale) {
    const std::size_t begin = run * kRun, end = std::min(begin + kRun, derived.order.size());
    runs_[run] = {};
    for (std::size_t i = begin; i < end; ++i) runs_[run] = both(runs_[run], box_of(axes, derived.shape_at(i)));
    looked_at_ += end - begin;
  }
  box_ = {};
  for (const LightBox& run : runs_) box_ = both(box_, run);
  return box_;
}

LightBox light_box(const SunAxes& axes, std::span<const sim::Pose> carts) {
  LightBox box;
  for (const sim::Pose& cart : carts)
    box.add(axes.of(glm::vec3(cart.position)),
            kCarMargin + static_cast<float>(std::max(cart.length - world::kCarLength, 0.0)));
  return box;
}

ShadowFit fit_shadow(const SunAxes& axes, const LightBox& box, float least, glm::vec3 eye, glm::vec3 forward) {
  if (box.empty()) return {};
  const glm::vec3 size = box.high - box.low;
  const float whole = power_of_two(least, std::max(size.x, size.y) / 0.87f);  // the middle is off by up to a sixteenth
  const glm::vec3 at = axes.of(eye);
  // Track farther away than a few sides of the square is small on the screen.
  const float seen = power_of_two(least, 2.5f * std::max(distance_to(box, at), std::abs(eye.y)));
  ShadowFit fit;
  fit.side = std::min(whole, seen);
  fit.middle = 0.5f * (box.low + box.high);
  if (fit.side < whole) {
    const glm::vec3 ahead = axes.of(eye + 0.3f * fit.side * forward);
    const glm::vec3 inside = glm::clamp(ahead, glm::min(box.low + 0.5f * fit.side, fit.middle),
                                        glm::max(box.high - 0.5f * fit.side, fit.middle));
    fit.middle = {inside.x, inside.y, fit.middle.z};
  }
  // The depth also moves in steps, so that a dragged knot does not change how everything else is drawn.
  const float step = fit.side / 8, layer = 8;
  fit.middle.x = step * std::round(fit.middle.x / step);
  fit.middle.y = step * std::round(fit.middle.y / step);
  const float far = layer * std::floor((box.low.z - kDepthMargin) / layer),
              near = layer * std::ceil((box.high.z + kDepthMargin) / layer);
  fit.middle.z = 0.5f * (far + near);
  fit.depth = near - far;
  return fit;
}

glm::mat4 clip_of(const SunAxes& axes, const ShadowFit& fit) {
  // Rows are the light's axes, scaled; depth increases away from the sun.
  const float flat = 2 / fit.side, deep = -2 / fit.depth;
  const glm::vec3 x = flat * axes.across, y = flat * axes.over, z = deep * axes.sun;
  return {glm::vec4(x.x, y.x, z.x, 0), glm::vec4(x.y, y.y, z.y, 0), glm::vec4(x.z, y.z, z.z, 0),
          glm::vec4(-flat * fit.middle.x, -flat * fit.middle.y, -deep * fit.middle.z, 1)};
}

glm::mat4 map_of(const SunAxes& axes, const ShadowFit& fit) {
  return glm::translate(glm::mat4(1), glm::vec3(0.5f)) * glm::scale(glm::mat4(1), glm::vec3(0.5f)) * clip_of(axes, fit);
}

}  // namespace coaster::gfx
