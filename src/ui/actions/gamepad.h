// A gamepad for the cameras: sticks and triggers move them, buttons play, reset and choose the next one.
#pragma once

#include "ui/actions/actions.h"

namespace coaster::ui {

// Returns a stick's deflection without its dead zone (the inner 18 %), squared for fine control near the centre: 0..1,
// same direction.
glm::vec2 shaped_stick(glm::vec2 stick);
float shaped_trigger(float trigger);

// State of sticks, triggers and buttons between frames.
class Gamepad {
 public:
  // Runs once a frame: moves the current camera by sticks and triggers over the time of the events' ticks, and runs the
  // actions of pressed buttons. `asking`: a dialog is open; input is ignored.
  void work(ActionContext& act, const platform::Events& events, bool asking);

 private:
  void move(Ui& ui, const view::Viewport& scene, double seconds) const;
  platform::GamepadAxes held_;
  bool focused_ = true;
};

// Returns the action of a button: "Play or pause" for A, "Next camera" for Y, for B "Cancel" if there is something to
// cancel and "Reset" otherwise, "" for X.
std::string_view action_of(platform::PadButton button, const ActionContext& act);

}  // namespace coaster::ui
