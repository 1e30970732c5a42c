#include "ui/tools/append_place.h"

#include <cmath>

namespace coaster::ui {

std::optional<glm::vec3> append_place(const world::Document& document, const view::View& view, glm::vec2 pixel) {
  const view::Ray ray = view::ray_through(view, pixel);
  if (view.parallel <= 0) return view::meet_plane(ray, glm::vec3(0), {0, 1, 0});
  const world::Track& track = document.track;
  const glm::vec3 last = track.knots.empty() ? glm::vec3(0) : world::knot(document, track.knots.back()).position;
  const glm::vec3 normal = view::line_of_sight(view);
  auto at = view::meet_plane(ray, last, normal);
  for (int i = 0; at && i < 3; ++i)
    if (std::abs(normal[i]) == 1) (*at)[i] = last[i];  // to the bit
  return at;
}

}  // namespace coaster::ui
