// The marks that are on screen and which covers which: what the overlay draws and what picking picks is this one list.
#pragma once

#include <vector>

#include "view/pick.h"

namespace coaster::view {

// World to window pixels in double; only what is between the near and the far plane has a place.
class Projector {
 public:
  explicit Projector(const View& view);
  std::optional<glm::dvec2> operator()(glm::dvec3 world) const;
  const glm::dmat4& matrix() const { return matrix_; }
  glm::dvec2 to_pixels(glm::dvec2 ndc) const;

 private:
  glm::dmat4 matrix_;
  Viewport viewport_;
};

struct PlacedMark {
  PickKind kind = PickKind::knot;
  world::Entity knot;
  glm::vec3 position{0};
  glm::dvec2 pixel{0};
  double distance = 0;    // m^2, square of the distance from the eye
  std::size_t order = 0;  // place in the track; the in-handle counts before the out-handle
};

// Knots, and the handles of the selection, in no special order.
std::vector<PlacedMark> marks_on_screen(const world::Document& document, const world::Settings& settings,
                                        const View& view);

// True when `a` is drawn over `b`: handles over knots, then the nearer one, then the earlier in the track.
bool covers(const PlacedMark& a, const PlacedMark& b);

// Knots whose handles are shown: the selected one, or both of the selected segment.
std::vector<world::Entity> knots_with_handles(const world::Document& document, const world::Settings& settings);

}  // namespace coaster::view
