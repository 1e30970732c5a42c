// Positions under the cursor other than marks: where a click appends a knot, and the track in front of the gizmo.
#pragma once

#include <optional>

#include "ui/context/ui.h"
#include "view/pick.h"

namespace coaster::ui {

// Returns the position of a new knot under a pixel, m, at the default height of new tracks. In an orthographic view: in
// its plane through the last knot, at least at that height. Nothing if the pixel shows no ground.
std::optional<glm::vec3> append_place(const world::Document& document, const view::View& view, glm::vec2 pixel);

// Returns what is under the mouse. A finger covers more than a pixel: where it is exactly on no mark, it takes one
// nearby.
view::Pick under_mouse(const Ui& ui, const view::View& view);

// Returns the track or train under the cursor if it is in front of the whole gizmo at `gizmo`, m.
std::optional<view::Pick> in_front_of_gizmo(const Ui& ui, const view::View& view, glm::vec3 gizmo);

}  // namespace coaster::ui
