// Keys of the free camera, by their place on a US layout: W A S D to move, E and Q for up and down, Shift for four
// times the speed.
#pragma once

#include <array>

#include "platform/events.h"
#include "ui/context/ui.h"

namespace coaster::ui {

// The held keys, between frames.
class FlyKeys {
 public:
  // Moves the free camera, if it is selected, over the time of the events' ticks. Call it once a frame. Ignores keys
  // pressed while a text field has the keyboard, or with Ctrl or Alt.
  void fly(Ui& ui, const platform::Events& events, bool text_has_keyboard);

 private:
  std::array<bool, 6> held_{};
  bool fast_ = false;
};

// True if the key moves the free camera while that is selected.
bool is_fly_key(const platform::KeyPress& press);

// Returns the camera after this frame's commands.
world::Camera camera_now(const Ui& ui);
world::FlyCamera fly_now(const Ui& ui);

// Returns the camera moved by `by` (right, up, forward; m) in its own axes, except that up is the world's. It stays
// above the ground and within the coordinate limits.
world::FlyCamera flown(world::FlyCamera fly, glm::vec3 by);
// Returns the camera turned by a drag of `pixels`, to the right and down with the mouse.
world::FlyCamera looked(world::FlyCamera fly, glm::vec2 pixels, float scale);

// Selects a camera; the free one starts at the present eye.
void choose_camera(Ui& ui, world::CameraMode mode);

}  // namespace coaster::ui
