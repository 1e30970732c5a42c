// Keeps new track in view: when the open end or the palette's preview leaves the picture, the orbit camera moves,
// damped, until it is visible. Never while the mouse or a number field drags something.
#pragma once

#include <optional>

#include <glm/glm.hpp>

#include "ui/context/ui.h"

namespace coaster::ui {

class FollowCamera {
 public:
  // Call it once a frame, after the tools: emits the camera of this frame while it moves. `busy`: the user drags
  // something.
  void update(Ui& ui, const view::View& view, bool busy);

 private:
  struct Seen {
    std::size_t knots = 0;
    glm::vec3 end{0};                // m, the last knot
    std::vector<glm::vec3> preview;  // preview_points()
    friend bool operator==(const Seen&, const Seen&) = default;
  };
  std::optional<Seen> seen_;         // the last state; nothing before the first frame
  std::optional<world::Camera> to_;  // target of the camera's motion
  world::Camera sent_;               // its last step
};

// Returns the knots of the displayed way home, or else of the palette's preview, m; empty if neither shows.
std::vector<glm::vec3> preview_points(const Ui& ui);

}  // namespace coaster::ui
