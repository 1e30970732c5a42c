// Keeps new track in view: when the open end, the section just placed there or the palette's preview leaves the
// picture, or the track is closed, the orbit camera moves, damped, until it is visible. Never while the mouse or a
// number field drags something, and not for an end that a change of earlier track moves while it is out of the picture,
// or that undo moves back.
#pragma once

#include <optional>

#include <glm/glm.hpp>

#include "ui/context/ui.h"

namespace coaster::ui {

class FollowCamera {
 public:
  // Call it once a frame, after the tools: emits the camera of this frame while it moves. `free` is the part of the
  // scene that nothing covers; `busy`: the user drags something.
  void update(Ui& ui, const view::View& view, const view::Viewport& free, bool busy);

 private:
  struct Seen {
    world::Entity last;              // the last knot of an open track
    glm::vec3 end{0};                // m, its position
    std::vector<glm::vec3> preview;  // preview_points()
    friend bool operator==(const Seen&, const Seen&) = default;
  };
  std::size_t undone_ = 0;                       // steps that redo has in the last frame: more of them are an undo
  bool busy_ = false;                            // in the last frame: its commands may still change the track
  std::optional<Seen> seen_;                     // the last state; nothing before the first frame
  std::optional<world::Camera> to_;              // target of the camera's motion
  world::Camera sent_;                           // its last step
  std::optional<world::Camera> before_preview_;  // where a preview took it away: a smaller one takes it back
};

// Returns the camera that shows the whole track in `free`, the part of the scene that nothing covers.
world::Camera framed_all(const edit::Session& session, const view::Viewport& scene, const view::Viewport& free);

// Returns the knots of the displayed way home, or else of the palette's preview, m; empty if neither shows.
std::vector<glm::vec3> preview_points(const Ui& ui);

}  // namespace coaster::ui
