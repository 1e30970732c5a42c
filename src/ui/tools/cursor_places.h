// Where a click appends a knot.
#pragma once

#include <optional>

#include "view/camera.h"

namespace coaster::ui {

// Returns the position under a pixel, m, at the height at which tracks begin. In an orthographic view: in its plane
// through the last knot, and at least so high. Nothing where the pixel shows no ground.
std::optional<glm::vec3> append_place(const world::Document& document, const view::View& view, glm::vec2 pixel);

}  // namespace coaster::ui
