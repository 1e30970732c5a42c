// What is under the cursor: knots, handles of the selected knot, carts, places on the curve. On the CPU, over derived data.
#pragma once

#include <optional>

#include "view/camera.h"
#include "world/motion.h"

namespace coaster::view {

enum class PickKind : std::uint8_t { none, knot, handle_in, handle_out, cart, curve };

struct Pick {
  PickKind kind = PickKind::none;
  world::Entity entity;     // knot, cart or segment
  double t = 0;             // parameter on the segment, for curve
  glm::vec3 position{0};    // m
  friend bool operator==(const Pick& a, const Pick& b) { return a.kind == b.kind && a.entity == b.entity; }
};

// Sizes on screen at UI scale 1, in pixels: what the marks are drawn with, and picked with.
inline constexpr float kKnotRadius = 6.5f;
inline constexpr float kHandleHalf = 5.0f;    // half the side of the handle's square
inline constexpr float kCurveReach = 8.0f;    // px from the curve

// Marks are on top of everything and never hidden. Handles beat knots, knots beat carts, carts beat the curve; within a kind the
// mark nearest to the eye wins (ties: the earlier in the track). Carts are picked by their box, oriented as drawn.
// Only handles of `selected` (a knot, or the knots of a selected segment) exist on screen and can be picked.
Pick pick(const world::Document& document, const sim::Derived& derived, const world::Motion& motion, const world::Settings& settings,
          const View& view, glm::vec2 pixel);

// The place on the curve nearest to a pixel, if within `reach` px of it: exact, by Newton on the projected distance.
std::optional<Pick> pick_curve(const sim::Derived& derived, const View& view, glm::vec2 pixel, float reach);

// Where a script's aim at a pick's name lands: the mark's position in the world, or nothing if it is not on screen.
std::optional<glm::vec3> position_of(const world::Document& document, const sim::Derived& derived, const world::Motion& motion,
                                     PickKind kind, world::Entity entity, double t);

}  // namespace coaster::view
