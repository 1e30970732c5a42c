// The brush of the ground: a ring under the mouse, and strokes while the left button is held. A slope is two clicks.
#pragma once

#include <optional>

#include <glm/glm.hpp>

#include "ui/context/ui.h"
#include "view/camera.h"

namespace coaster::ui {

class GroundBrush {
 public:
  // True if a brush is chosen and there is a land to work on.
  static bool chosen(const edit::Session& session);
  // Draws the ring, takes the wheel for its size, and emits the commands of a stroke, which is one undo step. `over`:
  // the mouse is over the scene. Call it each frame while a brush is chosen or a stroke goes on.
  void update(Ui& ui, const view::View& view, bool over);
  bool painting() const { return stroke_.has_value(); }
  // Reverts the stroke, or forgets where a slope was to begin. Returns false if there was neither.
  bool cancel(Ui& ui);

 private:
  struct Stroke {
    glm::vec2 last{0};     // m, (x, z): its last dab
    double height = 0;     // m, of the land where it began
    double due = 0;        // s, until the next dab
    bool gesture = false;  // BeginGesture was emitted
  };
  void press(Ui& ui, glm::vec2 at);
  void paint(Ui& ui, glm::vec2 at);
  void dab(Ui& ui, glm::vec2 at);
  void end(Ui& ui);

  std::optional<Stroke> stroke_;
  std::optional<glm::vec2> slope_from_;  // m, (x, z): the first click of a slope
};

}  // namespace coaster::ui
