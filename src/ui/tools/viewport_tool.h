// The mouse in the viewport: hovering, selecting, dragging knots and handles, boxes, appending, and the orbit camera.
// Keeps only the current drag.
#pragma once

#include <optional>

#include <glm/glm.hpp>

#include "ui/context/ui.h"
#include "ui/tools/ground_brush.h"
#include "ui/tools/selecting.h"
#include "ui/tools/transform_tool.h"
#include "view/pick.h"

namespace coaster::ui {

class ViewportTool {
 public:
  // Reads the mouse from ImGui, emits commands, and returns the item under the cursor (or the dragged one). Call it
  // after the panels.
  view::Pick update(Ui& ui, const view::View& view);
  bool dragging() const { return drag_.what != DragTarget::nothing || transform_.active() || brush_.painting(); }
  bool painting() const { return brush_.painting(); }
  TransformTool& transform() { return transform_; }
  const TransformTool& transform() const { return transform_; }
  // The next left drag draws a box that selects the knots in it.
  void wait_for_box() { box_waits_ = true; }
  bool box_waits() const { return box_waits_ || drag_.what == DragTarget::box; }
  // Reverts the current drag. Returns false if there was none.
  bool cancel(Ui& ui);

 private:
  enum class DragTarget : std::uint8_t { nothing, item, spin, section, place, cart, orbit, pan, box };
  enum class DragPlane : std::uint8_t { screen, vertical, ground };  // direction of a drag
  struct Drag {
    DragTarget what = DragTarget::nothing;
    int button = 0;
    view::Pick pick;
    glm::vec2 start{0}, last{0};       // px
    bool moved = false;                // by 3 points or more; otherwise it is a click
    bool click_acts = false;           // pressed on empty ground: a click appends or deselects
    bool shift = false, ctrl = false;  // held at the press
    BoxMode box = BoxMode::replace;
    bool gesture = false;  // BeginGesture was emitted
    DragPlane along = DragPlane::screen;
    bool grabbed = false;
    glm::vec3 anchor{0}, offset{0};  // m: position of the item at the press, and its offset from the ray's hit
    glm::vec3 sent{0};               // m: the position of the last command
    // For a section's handle: its value divided by that under the cursor at the press, or its angle minus that (deg).
    std::optional<double> grip;
  };

  void press(Ui& ui, const view::View& view, const view::Pick& under);
  void press_left(Ui& ui, const view::Pick& under);
  void move(Ui& ui, const view::View& view, glm::vec2 mouse);
  void move_item(Ui& ui, const view::View& view, glm::vec2 mouse);
  void pull_section(Ui& ui, const view::View& view, glm::vec2 mouse);
  void turn_section(Ui& ui, const view::View& view, glm::vec2 mouse);
  void change_section(Ui& ui, std::string_view parameter, double value);
  void turn_spin(Ui& ui, const view::View& view, glm::vec2 mouse);
  void release(Ui& ui, const view::View& view);
  void turn_wheel(Ui& ui, const view::View& view, float notches);
  void click_ground(Ui& ui, const view::View& view);
  void click_knot(Ui& ui);
  void click_handle(Ui& ui);
  void move_knots(Ui& ui, glm::vec3 to);

  Drag drag_;
  TransformTool transform_;
  GroundBrush brush_;
  std::optional<view::Pick> in_front_;              // in front of the pressed part of the gizmo: a click selects it
  bool box_waits_ = false, chose_section_ = false;  // the last press chose a section
};

// Returns the position of a new knot under a pixel, m, at the default height of new tracks above the ground, or above
// the land as people left it or its water. In an orthographic view: in its plane through the last knot, without a land
// at least at that height. Nothing if the pixel shows no ground.
std::optional<glm::vec3> append_place(const world::Document& document, const view::View& view, glm::vec2 pixel);

}  // namespace coaster::ui
