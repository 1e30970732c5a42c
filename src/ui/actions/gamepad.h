// A gamepad for the cameras: sticks and triggers move them, buttons play, reset and choose the next one.
#pragma once

#include "ui/actions/actions.h"

namespace coaster::ui {

// A stick's place without its dead zone (the inner 18 %, where springs let it rest) and bent, so that small moves are
// fine: 0..1 in the same direction, the square of how far it is beyond the dead zone.
glm::vec2 shaped_stick(glm::vec2 stick);
float shaped_trigger(float trigger);

// What is held, over frames.
class Gamepad {
 public:
  // One frame: emits where sticks and triggers take the chosen camera in the time that the events' ticks tell, and runs
  // what buttons stand for. `asking`: a question or browser is open, which has no use for it.
  void work(Act& act, const platform::Events& events, bool asking);

 private:
  void move(Ui& ui, const view::Viewport& scene, double seconds) const;
  platform::GamepadAxes held_;
  bool focused_ = true;
};

// "Play or pause" for A, "Next camera" for Y; for B "Cancel" while there is something to cancel, else "Reset"; nothing
// for X.
std::string_view action_of(platform::PadButton button, const Act& act);

}  // namespace coaster::ui
