// The mouse in the viewport: hovering, selecting, dragging knots and handles, boxes, appending, and the orbit camera.
// Keeps only the current drag.
#pragma once

#include <glm/glm.hpp>

#include "ui/context/ui.h"
#include "ui/tools/selecting.h"
#include "ui/tools/transform_tool.h"

namespace coaster::ui {

class ViewportTool {
 public:
  // After the panels: reads the mouse from ImGui, emits commands, returns what is under the cursor (or dragged).
  view::Pick update(Ui& ui, const view::View& view);
  bool dragging() const { return drag_.what != What::nothing || transform_.active(); }
  TransformTool& transform() { return transform_; }
  const TransformTool& transform() const { return transform_; }
  // The next left drag draws a box that selects the knots in it.
  void wait_for_box() { box_waits_ = true; }
  bool box_waits() const { return box_waits_ || drag_.what == What::box; }
  // Cancels the drag and what it changed. Returns false if there was none.
  bool cancel(Ui& ui);

 private:
  enum class What : std::uint8_t { nothing, item, spin, section, place, cart, orbit, pan, box };
  enum class Along : std::uint8_t { screen, vertical, ground };  // where a dragged item moves
  struct Drag {
    What what = What::nothing;
    int button = 0;
    view::Pick pick;
    glm::vec2 start{0}, last{0};       // px
    bool moved = false;                // 3 px or more: else it is a click
    bool click_acts = false;           // pressed on empty ground: a click appends or deselects
    bool shift = false, ctrl = false;  // held at the press
    BoxMode box = BoxMode::replace;
    bool gesture = false;  // BeginGesture was emitted
    Along along = Along::screen;
    bool grabbed = false;
    glm::vec3 anchor{0}, offset{0};  // m: the item when grabbed, and its distance from the ray's hit
    glm::vec3 sent{0};               // m: the position of the last command
    // Of a section's handle when grabbed: its value by that under the cursor, or its angle less that (deg).
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
  std::optional<view::Pick> in_front_;              // of the gizmo's part that is pressed: a click selects it
  bool box_waits_ = false, chose_section_ = false;  // the last press chose a section
};

// The camera that is shown, whatever is chosen.
world::CameraMode shown_camera(const Ui& ui);
// Return the camera after a drag by `pixels`, rotated about its target or moved with it, and after a turn of the wheel.
// The scene follows the mouse; a drag about the target leaves an orthographic view, whose point under the cursor stays
// when the wheel turns.
world::Camera orbited(world::Camera camera, glm::vec2 pixels, float scale);
world::Camera panned(world::Camera camera, const view::View& view, glm::vec2 pixels);
world::Camera zoomed(world::Camera camera, const view::View& view, glm::vec2 cursor, float notches);
// Sets the orbit camera and its projection.
void set_camera(Ui& ui, const world::Camera& camera);
// Sets the distance of the chase camera.
void zoom_chase(Ui& ui, float notches);

}  // namespace coaster::ui
