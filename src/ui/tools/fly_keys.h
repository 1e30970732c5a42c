// Keys of the free camera: W A S D to move, E and Q for up and down, Shift for four times the speed.
#pragma once

#include <array>

#include "platform/events.h"
#include "ui/context/ui.h"

namespace coaster::ui {

// Which of them are held, over frames.
class FlyKeys {
 public:
  // One frame: moves the free camera, if it is selected, over the time of the events' ticks. Ignores keys pressed while
  // a text field has the keyboard, or with Ctrl or Alt.
  void fly(Ui& ui, const platform::Events& events, bool text_has_keyboard);

 private:
  std::array<bool, 6> held_{};
  bool fast_ = false;
};

// Whether the key belongs to the free camera while that is chosen.
bool is_fly_key(const platform::KeyPress& press);

// The cameras as this frame's commands have left them.
world::Camera camera_now(const Ui& ui);
world::FlyCamera fly_now(const Ui& ui);

// Moved by `by` (right, up, forward; m) seen from it: up is the world's. Stays over the ground and within coordinates.
world::FlyCamera flown(world::FlyCamera fly, glm::vec3 by);
// The head turned by a drag of `pixels`: to the right and down with the mouse.
world::FlyCamera looked(world::FlyCamera fly, glm::vec2 pixels, float scale);

// Chooses a camera; the free one begins where the eye is.
void choose_camera(Ui& ui, world::CameraMode mode);

}  // namespace coaster::ui
