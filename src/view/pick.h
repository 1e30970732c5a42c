// What is under the cursor: knots, handles of the selected knot, carts, places on the curve. On the CPU, over derived
// data.
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
  world::Entity entity;   // knot, cart or segment
  double t = 0;           // parameter on the segment, for curve
  glm::vec3 position{0};  // m
  friend bool operator==(const Pick& a, const Pick& b) { return a.kind == b.kind && a.entity == b.entity; }
};

// Sizes on screen at UI scale 1 (they grow with it), in pixels: what the marks are drawn with, and picked with.
inline constexpr float kKnotRadius = 5.0f;
inline constexpr float kHandleHalf = 4.0f;  // half the side of the handle's square
inline constexpr float kCurveReach = 8.0f;  // px from the curve
inline constexpr float kCartReach =
    9.0f;  // px from a cart's middle: more than a knot's radius, so that a cart on a knot can be picked beside it

// Marks are on top of everything and never hidden. Handles beat knots, knots the gizmo, that carts, carts beat the
// curve; within a kind the mark nearest to the eye wins (ties: the earlier in the track). Carts are picked by their
// box, oriented as drawn, and near their middle however small they look; not the one that the eye sits in. Where curves
// cross on screen the selected one wins near its picked place. Only handles of `selected` (a knot, or the knots of a
// selected segment) exist on screen and can be picked.
Pick pick(const world::Document& document, const sim::Derived& derived, const world::Motion& motion,
          const world::Settings& settings, const View& view, glm::vec2 pixel);

// The place on the curve nearest to a pixel on screen, if within `reach` px of it. Where the track passes the pixel
// more than once, each time within kOneBehindAnother of the nearest, the place nearest to the eye is meant; of those
// equally near to it (to a thousandth of the depth) the one nearest on screen, and of those the earlier in the track,
// so a joint belongs to the segment that it ends. t to 1e-6. What is behind the eye or nearer than the near plane does
// not count; without an eye (a view that is not perspective) nothing is found. Cost: about a microsecond at 100,000
// segments (docs/performance.md), by derived.tree.
std::optional<Pick> pick_curve(const sim::Derived& derived, const View& view, glm::vec2 pixel, float reach);
inline constexpr double kOneBehindAnother = 1.0;  // px

// The same by looking at every segment: what the hierarchy is held to, and measured beside.
std::optional<Pick> pick_curve_of_all(const sim::Derived& derived, const View& view, glm::vec2 pixel, float reach);

// The place on one segment that is nearest to a pixel on screen, however far from it; nothing when none of it is in
// front of the eye or the segment is gone: what the probe follows while it is dragged.
std::optional<Pick> pick_segment(const sim::Derived& derived, const View& view, glm::vec2 pixel, world::Entity segment);

// Where a script's aim at a pick's name lands: the position of the mark, the place on the curve, the middle of the
// cart; nothing when there is no such entity.
std::optional<glm::vec3> position_of(const world::Document& document, const sim::Derived& derived,
                                     const world::Motion& motion, PickKind kind, world::Entity entity, double t);

}  // namespace coaster::view
