// The cameras: the orbit camera under the mouse, the free camera under keys, and the orbit camera that follows new
// track.
#pragma once

#include <array>
#include <optional>

#include <glm/glm.hpp>

#include "platform/events.h"
#include "ui/context/ui.h"

namespace coaster::ui {

// Keys of the free camera, by their place on a US layout: W A S D to move, E and Q for up and down, Shift for four
// times the speed. Holds the pressed keys between frames.
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
world::FlyCamera flown(world::FlyCamera fly, glm::vec3 by, const sim::Ground& ground);
// Returns the camera turned by a drag of `pixels`, to the right and down with the mouse.
world::FlyCamera looked(world::FlyCamera fly, glm::vec2 pixels, float scale);

// Selects a camera; the free one starts at the present eye.
void choose_camera(Ui& ui, world::CameraMode mode);

// Keeps new track in view: when the open end, the section just placed there or the palette's preview leaves the
// picture, or the track is closed, the orbit camera moves, damped, until it is visible. Never while the mouse or a
// number field drags something, and not for an end that a change of earlier track moves while it is out of the picture,
// or that undo moves back.
class FollowCamera {
 public:
  // Call it once a frame, after the tools: emits the camera of this frame while it moves. `free` is the part of the
  // scene that nothing covers; `busy`: the user drags something.
  void update(Ui& ui, const view::View& view, const view::Viewport& free, bool busy);

 private:
  struct FollowedState {
    world::Entity last;              // the last knot of an open track
    glm::vec3 end{0};                // m, its position
    std::vector<glm::vec3> preview;  // preview_points()
    friend bool operator==(const FollowedState&, const FollowedState&) = default;
  };
  std::size_t undone_ = 0;                       // steps that redo has in the last frame: more of them are an undo
  bool busy_ = false;                            // in the last frame: its commands may still change the track
  std::optional<FollowedState> seen_;            // the last state; nothing before the first frame
  std::optional<world::Camera> to_;              // target of the camera's motion
  world::Camera sent_;                           // its last step
  std::optional<world::Camera> before_preview_;  // where a preview took it away: a smaller one takes it back
};

// Returns the camera that shows the whole track in `free`, the part of the scene that nothing covers.
world::Camera framed_all(const edit::Session& session, const view::Viewport& scene, const view::Viewport& free);

// Returns the mode of the camera on display, which may differ from the selected one.
world::CameraMode shown_camera(const Ui& ui);
// Return the camera after a drag by `pixels` that rotates it about its target or moves it with the target, and after a
// turn of the wheel. The scene follows the mouse. Rotating leaves an orthographic view; the wheel zooms an orthographic
// view about the point under the cursor.
world::Camera orbited(world::Camera camera, glm::vec2 pixels, float scale);
world::Camera panned(world::Camera camera, const view::View& view, glm::vec2 pixels);
world::Camera zoomed(world::Camera camera, const view::View& view, glm::vec2 cursor, float notches);
// Sets the orbit camera and its projection.
void set_camera(Ui& ui, const world::Camera& camera);
// Changes the distance of the chase camera.
void zoom_chase(Ui& ui, float notches);

}  // namespace coaster::ui
