#include "ui/tools/cursor_places.h"

#include <algorithm>
#include <cmath>

#include "sim/plan/element_shapes.h"

namespace coaster::ui {

std::optional<glm::vec3> append_place(const world::Document& document, const view::View& view, glm::vec2 pixel) {
  const auto standing = static_cast<float>(sim::TrackEnd{}.position.y);
  const view::Ray ray = view::ray_through(view, pixel);
  const world::Track& track = document.track;
  if (view.parallel <= 0) {
    const auto ground = view::meet_plane(ray, glm::vec3(0), {0, 1, 0});
    const auto at = ray.origin.y > standing ? view::meet_plane(ray, {0, standing, 0}, {0, 1, 0}) : ground;
    return ground && at ? std::optional(glm::vec3(at->x, standing, at->z)) : std::nullopt;
  }
  const glm::vec3 normal = view::line_of_sight(view), last = track.knots.empty()
                                                                 ? glm::vec3(0, standing, 0)
                                                                 : world::knot(document, track.knots.back()).position;
  auto at = view::meet_plane(ray, last, normal);
  if (!at) return at;
  for (int i = 0; i < 3; ++i)
    if (std::abs(normal[i]) == 1) (*at)[i] = last[i];  // to the bit
  at->y = std::max(at->y, standing);
  return at;
}

}  // namespace coaster::ui
