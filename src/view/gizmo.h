// The arrows and squares that move the selected knots along one axis or in one plane, and the ring that sets the spin
// of one. Constant size on screen.
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

inline constexpr float kSpinRadius = 92;     // px at UI scale 1, outside the gizmo's arrows
inline constexpr double kSpinAhead = 5;      // m: the handle is at the roll that the spin makes over this length
inline constexpr double kSpinMost_deg = 36;  // deg/m, at the ring's far side; larger spins show there

struct SpinRing {
  world::Entity knot;
  glm::dvec3 centre{0}, tangent{1, 0, 0}, up{0, 1, 0};  // m; unit
  double radius = 1;                                    // m
  double spin = 0;                                      // rad/m
  // Returns the point of the ring at an angle (rad) from `up`, positive to the rider's right.
  glm::dvec3 at(double angle) const;
  glm::dvec3 handle() const;
};

// Returns nothing unless one knot is selected and the gizmo is shown (view/gizmo.h).
std::optional<SpinRing> spin_ring_of(const world::Document& document, const world::Settings& settings,
                                     const View& view);

// Returns the spin (rad/m) whose handle is nearest to a ray; nothing if the ring is seen edge-on.
std::optional<double> spin_under(const SpinRing& ring, const Ray& ray);

// Adds the ring, and an arc from `up` to the handle.
void add_spin_ring(const SpinRing& ring, float scale, Overlay& overlay);

}  // namespace coaster::view
