// Where a click appends a knot.
#pragma once

#include <optional>

#include "view/camera.h"

namespace coaster::ui {

// Returns the position under a pixel, m: on the ground, or in an orthographic view in its plane through the last knot.
// Nothing where the pixel shows no ground.
std::optional<glm::vec3> append_place(const world::Document& document, const view::View& view, glm::vec2 pixel);

}  // namespace coaster::ui
