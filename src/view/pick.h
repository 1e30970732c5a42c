// Finds what is under the cursor: knots, handles of the selected knot, trains, positions on the curve. Runs on the CPU,
// over derived data.
#pragma once

#include <optional>

#include "view/camera.h"
#include "world/motion.h"

namespace coaster::view {

// axis_x .. plane_z: parts of the gizmo (view/gizmo.h), without an entity.
enum class PickKind : std::uint8_t {
  none,
  knot,
  handle_in,
  handle_out,
  spin,     // the handle of the spin ring (view/gizmo.h)
  section,  // the handle of the selected section (view/gizmo.h)
  turn,     // the handles of its angles (view/gizmo.h)
  bank,
  cart,
  curve,
  axis_x,
  axis_y,
  axis_z,
  plane_x,
  plane_y,
  plane_z
};

struct Pick {
  PickKind kind = PickKind::none;
  world::Entity entity;   // knot, cart, section or segment
  double t = 0;           // parameter on the segment, for curve
  glm::vec3 position{0};  // m
  friend bool operator==(const Pick& a, const Pick& b) { return a.kind == b.kind && a.entity == b.entity; }
};

// Sizes on screen at UI scale 1, in points. Marks are drawn with them times mark_scale() and, times View::reach, too,
// picked with them.
inline constexpr float kKnotRadius = 5.0f;
inline constexpr float kHandleHalf = 4.0f;  // half the side of the handle's square
inline constexpr float kSectionHandleHalf = 6.0f;
inline constexpr float kCurveReach = 8.0f;  // from the curve
inline constexpr float kCartReach = 9.0f;   // from a car's middle: more than a knot's radius

// Returns pixels per point of marks, lines and targets: the UI scale times the screen's density.
float mark_scale(const world::Settings& settings, const View& view);

// Returns what is under a pixel. Marks are on top of everything and never hidden. A section's handles win over other
// handles, handles over knots, knots over the gizmo, the gizmo over cars, cars over the curve; within a kind the mark
// nearest to the eye wins (ties: the earlier in the track). Cars are picked by their box, oriented as drawn, and near
// their middle however small they are; the car that contains the eye is not. Where curves cross on screen the selected
// one wins near its picked position. Only handles of `selected` (a knot, or the knots of a selected segment) are shown
// and can be picked.
Pick pick(const world::Document& document, const sim::DerivedTrack& derived, const world::Motion& motion,
          const world::Settings& settings, const View& view, glm::vec2 pixel);

// Returns the position on the curve nearest to a pixel on screen, if within `reach` px of it. If the track passes the
// pixel several times, each within kOneBehindAnother of the nearest, the position nearest to the eye wins; of those
// equally deep (to a thousandth of the depth) the one nearest on screen; of those the earlier in the track, so a joint
// belongs to the segment that it ends. t to 1e-6. Ignores positions behind the eye or before the near plane; finds
// nothing if the view is not perspective. Takes about a microsecond at 100,000 segments (docs/performance.md), by
// derived.tree.
std::optional<Pick> pick_curve(const sim::DerivedTrack& derived, const View& view, glm::vec2 pixel, float reach);
inline constexpr double kOneBehindAnother = 1.0;  // points

// Does the same by testing every segment: the reference for the tree in tests and benchmarks.
std::optional<Pick> pick_curve_of_all(const sim::DerivedTrack& derived, const View& view, glm::vec2 pixel, float reach);

// Returns the position on one segment that is nearest to a pixel on screen, at any distance; nothing if the segment is
// entirely behind the eye or does not exist. The probe follows it during a drag.
std::optional<Pick> pick_segment(const sim::DerivedTrack& derived, const View& view, glm::vec2 pixel,
                                 world::Entity segment);

// Returns the point that a script aims at: the position of the mark, the position on the curve, the middle of the car;
// nothing if there is no such entity. The handle of a spin has none without a view.
std::optional<glm::vec3> position_of(const world::Document& document, const sim::DerivedTrack& derived,
                                     const world::Motion& motion, PickKind kind, world::Entity entity, double t);

inline bool is_section_handle(PickKind kind) { return kind >= PickKind::section && kind <= PickKind::bank; }

}  // namespace coaster::view
