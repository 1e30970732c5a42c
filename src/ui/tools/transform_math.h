// Geometry of transforms: intersections of rays with axes and planes, rotation angles, snapping. No state, no ImGui.
#pragma once

#include <cstdint>
#include <optional>

#include "view/camera.h"
#include "world/settings.h"

namespace coaster::ui {

enum class TransformKind : std::uint8_t { move, rotate, scale };

// free: in the plane that faces the eye. axis: along one axis. plane: perpendicular to one axis.
struct Constraint {
  enum class Kind : std::uint8_t { free, axis, plane } kind = Kind::free;
  int axis = 0;  // 0 x, 1 y, 2 z
  friend bool operator==(const Constraint&, const Constraint&) = default;
  bool allows(int component) const { return kind == Kind::free || (kind == Kind::axis) == (component == axis); }
};

// Returns the intersection of the constraint through `pivot` with the ray through a pixel; nothing if the ray is
// parallel to the axis or the plane.
std::optional<glm::dvec3> meet(const view::View& view, glm::vec2 pixel, glm::vec3 pivot, const Constraint& constraint);

// Returns the angle (radians, -pi..pi) from `from` to `to` about the pivot on the screen, right-handed about `axis`.
double turned_angle(const view::View& view, glm::vec2 from, glm::vec2 to, glm::vec3 pivot, glm::vec3 axis);

// Returns the axis of a rotation: that of the constraint, or the line of sight.
glm::vec3 rotation_axis(const view::View& view, const Constraint& constraint);

// Returns the snapped `position` (m). Components that the constraint excludes keep the value of `start`. `knots` snaps
// to the nearest unselected knot within 12 points of the cursor, `ground` to where the ray meets it.
struct SnapScene {
  const world::Document& document;
  const world::Settings& settings;
  const view::View& view;
  glm::vec2 cursor;
};
glm::dvec3 snapped(const SnapScene& scene, world::SnapTo to, glm::dvec3 position, glm::dvec3 start,
                   const Constraint& constraint);

}  // namespace coaster::ui
