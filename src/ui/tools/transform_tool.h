// Moving, rotating and scaling the selected knots by the gizmo, or with G, R and S as in Blender, along an axis (X, Y,
// Z), in a plane (Shift+axis), or by typed numbers. Keeps only the current transform.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>

#include "ui/context/ui.h"
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

// Returns the snapped `position` (m). Components that the constraint excludes keep the value of `start`. `knots` snaps
// to the nearest unselected knot within 12 points of the cursor, `ground` to where the ray meets it: the land as people
// left it, without the cut that the track itself makes.
struct SnapScene {
  const world::Document& document;
  const world::Settings& settings;
  const view::View& view;
  glm::vec2 cursor;
};
glm::dvec3 snapped(const SnapScene& scene, world::SnapTo to, glm::dvec3 position, glm::dvec3 start,
                   const Constraint& constraint);

// Draws "Snap: grid 1 m" or "Snap: off" while knots are moved, rotated or scaled; the widget "Cursor/Snapping".
void draw_snap_label(Ui& ui, TransformKind kind, world::SnapTo to);

class TransformTool {
 public:
  bool active() const { return active_; }

  // Begins on the selected knots; no-op without any. Ends when `button` is released; without one, on Enter or a click.
  void begin(Ui& ui, TransformKind kind, Constraint constraint, std::optional<int> button);
  // Handles X Y Z, Shift+axis, digits, Tab, Backspace, Enter and G R S. Escape comes through cancel().
  void take_keys(const platform::Events& events);
  // Follows the mouse and emits at most one command; ends on a click or the button's release. Call it once a frame,
  // after the keys. Returns true if it ends as a click without movement.
  bool update(Ui& ui, const view::View& view);
  // Reverts the transform. Returns false if none is active.
  bool cancel(Ui& ui);

  // Returns "Move along X: 2.50 m"; empty when inactive.
  std::string status() const;

 private:
  void finish(Ui& ui);
  void emit(Ui& ui, const view::View& view);
  void refuse(Ui& ui, const std::string& mistake);
  std::optional<double> typed(std::size_t field) const;
  std::string mistyped() const;  // the error in the typed numbers; empty if there is none
  bool any_typed() const;
  std::size_t fields() const;
  void type(char c);
  edit::Command command(const Ui& ui, const view::View& view);
  glm::vec3 movement(const Ui& ui, const view::View& view);

  bool active_ = false, gesture_ = false, begun_ = false, entered_ = false;
  TransformKind kind_ = TransformKind::move;
  Constraint constraint_;
  std::optional<int> button_;
  edit::Knots knots_;
  glm::vec3 pivot_{0}, active_start_{0};  // m: mean position and active knot at the start
  glm::vec2 start_{0}, last_{0};          // px
  double angle_ = 0;                      // radians, accumulated beyond half a turn
  base::ShownUnit length_;                // unit of typed distances
  std::array<std::string, 3> text_;       // the typed numbers
  std::size_t field_ = 0;
  std::optional<platform::Key> of_keyboard_;  // the last key, if its text follows
  std::string sent_, shown_;                  // the last command, and its text for the status
};

}  // namespace coaster::ui
