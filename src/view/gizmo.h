// The arrows and squares at the selected knots that move them along one axis or in one plane. Constant size on screen.
#pragma once

#include <optional>

#include "view/overlay.h"

namespace coaster::view {

// Sizes at UI scale 1, in pixels along an axis perpendicular to the line of sight.
inline constexpr float kGizmoLength = 76, kGizmoGap = 20;          // end and start of the arrows
inline constexpr float kGizmoPlaneNear = 26, kGizmoPlaneFar = 44;  // corners of the squares, along both axes
inline constexpr float kGizmoReach = 6;                            // next to an arrow, in which it can be picked

struct Gizmo {
  glm::vec3 at{0};     // m: the mean of the selected knots' positions
  float metre_px = 1;  // pixels per metre across the line of sight there
};

// Returns nothing if no knot is selected, the gizmo or all panels are hidden, append mode is on, or its position is not
// in front of the eye.
std::optional<Gizmo> gizmo_of(const world::Document& document, const world::Settings& settings, const View& view);

// Returns the arrow (axis_x ..) or square (plane_x: normal to x ..) under a pixel, or PickKind::none. Arrows that point
// at the eye and squares seen edge-on cannot be picked.
PickKind pick_gizmo(const Gizmo& gizmo, const View& view, float scale, glm::vec2 pixel);

// Returns a point on the part's mark, m, for scripts to aim at. `kind` is one of its parts.
glm::vec3 gizmo_place(const Gizmo& gizmo, float scale, PickKind kind);

void add_gizmo(const Gizmo& gizmo, const View& view, float scale, PickKind hovered, Overlay& overlay);

inline bool is_gizmo(PickKind kind) { return kind >= PickKind::axis_x && kind <= PickKind::plane_z; }
inline bool is_axis(PickKind kind) { return kind >= PickKind::axis_x && kind <= PickKind::axis_z; }
// Returns 0 x, 1 y, 2 z: the axis of an arrow, the normal of a square.
inline int gizmo_axis(PickKind kind) { return (static_cast<int>(kind) - static_cast<int>(PickKind::axis_x)) % 3; }

}  // namespace coaster::view
