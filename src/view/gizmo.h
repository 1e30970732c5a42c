// The arrows and squares that move the selected knots along one axis or in one plane, and the ring that sets the spin
// of one. Constant size on screen.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "view/camera.h"
#include "view/overlay.h"
#include "view/pick.h"

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

// --- The handles of the selected section in the view: its height, length or radius on a line, its turn and bank on
// rings

struct SectionHandle {
  world::Entity section;
  std::string_view parameter;  // "height", "length" or "radius"
  double value = 0;            // present value of the parameter
  glm::dvec3 from{0}, at{0};   // m: where the section begins, and the handle, on the rails' curve
};

// Returns the handle of a planned section: its height at the point farthest above or below its start, else its length
// or its radius at its end. Nothing for other sections.
std::optional<SectionHandle> section_handle(const world::Document& document, const sim::DerivedTrack& derived,
                                            world::Entity section);
// True if handles show: in the workspace Build with one section selected.
bool section_handles_show(const world::Settings& settings);

// Returns the value of the parameter that puts the handle where the ray meets its line (height, length) or the level
// plane (radius); nothing if they do not meet. The position of a handle is proportional to its value.
std::optional<double> value_under(const SectionHandle& handle, const Ray& ray);

void add_section_handle(const SectionHandle& handle, float scale, bool hovered, Overlay& overlay);

struct AngleHandle {
  PickKind kind = PickKind::none;  // turn or bank
  world::Entity section;
  std::string_view parameter;  // "angle", "turns" or "bank"
  double angle = 0;            // deg, present value; a turn of 360 deg and more continues to count
  double whole = 1;            // value of the parameter divided by its angle in deg
  glm::dvec3 centre{0};        // m
  glm::dvec3 axis{0, 1, 0};    // unit, axis of positive angles
  glm::dvec3 zero{1, 0, 0};    // m, from the centre to the ring where the angle is 0
  glm::dvec3 at(double deg) const;
};

// Returns the handles of a planned section. An element that turns in plan has its turn, as a level ring about the
// centre of the turn at the height where it begins; one with a bank parameter has its bank, as a ring about the rails
// where it is steepest. A bank that follows from a speed has none.
std::vector<AngleHandle> angle_handles(const world::Document& document, const sim::DerivedTrack& derived,
                                       world::Entity section);
// Returns the handle of one kind.
std::optional<AngleHandle> angle_handle(const world::Document& document, const sim::DerivedTrack& derived,
                                        world::Entity section, PickKind kind);

// Returns the angle (deg) of the handle where the ray meets the ring's plane, with the whole turns that bring it
// nearest to `near`; nothing if the plane is seen edge-on.
std::optional<double> angle_under(const AngleHandle& handle, const Ray& ray, double near);

// Adds the ring, an arc from 0 to the angle, and the handle.
void add_angle_handle(const AngleHandle& handle, float scale, bool hovered, Overlay& overlay);

}  // namespace coaster::view
