#include "view/overlay_lab_parts.h"

#include <algorithm>
#include <cmath>

#include "sim/shape/rails.h"

namespace coaster::view {

PixelScale::PixelScale(const View& view)
    : eye_(view.eye),
      forward_(line_of_sight(view)),
      focal_px_(0.5 * static_cast<double>(view.viewport.height) * static_cast<double>(view.projection[1][1])),
      parallel_(view.parallel > 0) {}

double PixelScale::operator()(glm::dvec3 at) const {
  if (parallel_) return focal_px_;
  const double depth = glm::dot(at - eye_, forward_);
  return depth > 0 ? focal_px_ / depth : 0;
}

std::vector<world::Entity> selected_segments(const world::Document& document, world::Entity selected) {
  if (document.entities.find<world::Segment>(selected)) return {selected};
  if (!document.entities.find<world::Knot>(selected)) return {};
  const world::Neighbours at = world::neighbours(document, selected);
  std::vector<world::Entity> out{at.before, at.after};
  std::erase(out, world::kNone);
  return out;
}

glm::dvec3 over_rails(const sim::Derived& derived, double distance, double height) {
  const sim::TrackPlace place = sim::place_at(derived, distance);
  const sim::SegmentShape& shape = derived.shape(derived.order[place.index]);
  return sim::rails_at(shape, place.s) + height * sim::frame_at(shape, place.s).up;
}

void add_arrow(glm::dvec3 from, glm::dvec3 direction, double length, const View& view, float width_px,
               std::uint32_t rgba, Overlay& overlay) {
  constexpr double kBarb = 0.3, kHalfWidth = 0.14,
                   kAlong = 0.05;  // of the length; sine of the smallest angle to the line of sight
  const glm::dvec3 tip = from + length * direction;
  overlay.lines.push_back({glm::vec3(from), glm::vec3(tip), width_px, rgba});
  const glm::dvec3 to_eye = view.parallel > 0 ? -glm::dvec3(line_of_sight(view)) : glm::dvec3(view.eye) - from;
  const glm::dvec3 side = glm::cross(direction, to_eye);
  const double across = glm::length(side);
  if (!(across > kAlong * glm::length(to_eye))) return;
  const glm::dvec3 back = tip - kBarb * length * direction, out = side * (kHalfWidth * length / across);
  overlay.lines.push_back({glm::vec3(tip), glm::vec3(back + out), width_px, rgba});
  overlay.lines.push_back({glm::vec3(tip), glm::vec3(back - out), width_px, rgba});
}

void add_sign(glm::dvec3 at, std::uint32_t rgba, std::span<const glm::dvec2> glyph, const View& view, float scale,
              Overlay& overlay) {
  constexpr std::uint32_t kInk = 0x1b1f27ff;
  const double px_per_metre = PixelScale(view)(at);
  if (!(px_per_metre > 0)) return;
  add_disc(at, 11 * scale, rgba, overlay);
  // Uses dots, because marks are drawn over lines.
  const glm::dvec3 right(right_of(view)), up(top_of(view));
  const double metres = static_cast<double>(scale) / px_per_metre;
  for (const glm::dvec2 dot : glyph) add_disc(at + metres * (dot.x * right + dot.y * up), 1.5f * scale, kInk, overlay);
}

void add_band(const sim::Derived& derived, double from, double to, int pieces, float width_px, std::uint32_t rgba,
              Overlay& overlay) {
  constexpr double kOver = 0.35;  // m above the rails
  const auto at = [&](double distance) { return over_rails(derived, distance, kOver); };
  glm::dvec3 before = at(from);
  for (int i = 1; i <= pieces; ++i) {
    const glm::dvec3 next = at(from + (to - from) * i / pieces);
    add_line(before, next, width_px, rgba, overlay);
    before = next;
  }
}

std::vector<SeenSegment> seen_segments(const sim::Derived& derived, const View& view) {
  constexpr float kNearest = 1;  // m: closer track gets no more detail
  const glm::vec3 right = right_of(view), up = top_of(view), forward = line_of_sight(view);
  const float fx = view.projection[0][0], fy = view.projection[1][1];
  // A sphere is outside if it lies beyond a side plane of the frustum.
  const float side_x = std::sqrt(1 + fx * fx), side_y = std::sqrt(1 + fy * fy);
  const float focal_px = 0.5f * view.viewport.height * fy;
  std::vector<SeenSegment> seen;
  for (std::size_t i = 0; i < derived.order.size(); ++i) {
    const sim::SegmentShape& shape = derived.shape(derived.order[i]);
    const auto [low, high] = curve::control_box(shape.key.cubic);
    const float radius = 0.5f * glm::length(high - low);
    const glm::vec3 off = 0.5f * (low + high) - view.eye;
    if (view.parallel > 0) {
      if (std::abs(glm::dot(off, right)) * fx > 1 + radius * fx || std::abs(glm::dot(off, up)) * fy > 1 + radius * fy)
        continue;
      seen.push_back({i, focal_px, static_cast<double>(focal_px) * shape.arc.length()});
      continue;
    }
    const float depth = glm::dot(off, forward);
    if (depth < -radius || std::abs(glm::dot(off, right)) * fx - depth > radius * side_x ||
        std::abs(glm::dot(off, up)) * fy - depth > radius * side_y)
      continue;
    const double px_per_metre = static_cast<double>(focal_px / std::max(depth - radius, kNearest));
    seen.push_back({i, px_per_metre, px_per_metre * shape.arc.length()});
  }
  return seen;
}

}  // namespace coaster::view
