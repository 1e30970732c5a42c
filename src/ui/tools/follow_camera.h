// Keeps what is being built in view: when the open end or the palette's preview has moved out of the picture, the orbit
// camera moves until it shows, damped. Never while the mouse or a number drags something.
#pragma once

#include <optional>

#include <glm/glm.hpp>

#include "ui/context/ui.h"

namespace coaster::ui {

class FollowCamera {
 public:
  // Once a frame, after the tools: emits the camera of this frame while it moves. `busy`: the user drags something.
  void update(Ui& ui, const view::View& view, bool busy);

 private:
  struct Seen {
    std::size_t knots = 0;
    glm::vec3 end{0};                // m, the last knot
    std::vector<glm::vec3> preview;  // preview_points()
    friend bool operator==(const Seen&, const Seen&) = default;
  };
  std::optional<Seen> seen_;         // what was last looked at; nothing before the first frame
  std::optional<world::Camera> to_;  // where the camera goes
  world::Camera sent_;               // its last step
};

// The knots of the shown way home, or else of the palette's preview, m; empty where none shows.
std::vector<glm::vec3> preview_points(const Ui& ui);

}  // namespace coaster::ui
