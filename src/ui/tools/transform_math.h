// Geometry of transforms: intersections of rays with axes and planes, rotation angles, snapping. No state, no ImGui.
#pragma once

#include <cstdint>
#include <optional>

#include "view/camera.h"
#include "world/settings.h"

namespace coaster::ui {

enum class TransformKind : std::uint8_t { move, rotate, scale };

// free: in the plane that faces the eye. axis: along one. plane: across one.
struct Constraint {
  enum class Kind : std::uint8_t { free, axis, plane } kind = Kind::free;
  int axis = 0;  // 0 x, 1 y, 2 z
  friend bool operator==(const Constraint&, const Constraint&) = default;
  bool allows(int component) const { return kind == Kind::free || (kind == Kind::axis) == (component == axis); }
};

// Where the ray through a pixel is, as seen from `pivot`, within the constraint; nothing where it runs along the axis
// or the plane.
std::optional<glm::dvec3> meet(const view::View& view, glm::vec2 pixel, glm::vec3 pivot, const Constraint& constraint);

// Angle (radians, -pi..pi) by which the way from the pivot to the cursor has turned on the screen, right-handed about
// `axis`.
double turned_angle(const view::View& view, glm::vec2 from, glm::vec2 to, glm::vec3 pivot, glm::vec3 axis);

// The axis of a rotation: that of the constraint, or the line of sight.
glm::vec3 rotation_axis(const view::View& view, const Constraint& constraint);

// `position` (m) as snapping would have it. Components that the constraint does not allow stay those of `start`. For
// `knots`, the knot under the cursor that is not among those that move, if one is within 12 px times the scale; for
// `ground`, where the ray meets it.
struct SnapScene {
  const world::Document& document;
  const world::Settings& settings;
  const view::View& view;
  glm::vec2 cursor;
};
glm::dvec3 snapped(const SnapScene& scene, world::SnapTo to, glm::dvec3 position, glm::dvec3 start,
                   const Constraint& constraint);

}  // namespace coaster::ui
