// The marks on screen and their drawing order. The overlay draws this list, and picking uses the same list.
#pragma once

#include <vector>

#include "view/pick.h"

namespace coaster::view {

// Projects world points to window pixels in double; points outside the near and far planes have no pixel.
class Projector {
 public:
  explicit Projector(const View& view);
  std::optional<glm::dvec2> operator()(glm::dvec3 world) const;
  // False only if no point of the box is seen within `margin` pixels of the viewport.
  bool may_show(const curve::Box& box, double margin) const;

 private:
  glm::dmat4 matrix_;
  Viewport viewport_;
};

inline constexpr std::size_t kMostMarks = 2'500;  // drawn marks; all can be picked

struct PlacedMark {
  PickKind kind = PickKind::knot;
  world::Entity knot;
  glm::vec3 position{0};
  glm::dvec2 pixel{0};
  double distance = 0;    // m^2, square of the distance from the eye
  std::size_t order = 0;  // index in the track; the in-handle comes before the out-handle
};

// Returns a mark without its order; nothing if it is not on screen.
std::optional<PlacedMark> placed_mark(const Projector& projector, const View& view, PickKind kind, world::Entity knot,
                                      glm::vec3 position);

// The selection as a table, for fast lookup.
class SelectionLookup {
 public:
  explicit SelectionLookup(const world::Settings& settings);
  bool operator()(world::Entity e) const { return e == active_ || (e.index < also_.size() && also_[e.index] == e); }
  bool several() const { return !also_.empty(); }

 private:
  world::Entity active_;
  std::vector<world::Entity> also_;  // by index
};

// Which marks are drawn.
struct MarkChoice {
  bool all = true;                // false: only those of selected and hovered knots
  bool spin = true;               // with the handle of the spin ring
  Pick hovered;                   // shown at any distance, as is the active knot
  std::size_t most = kMostMarks;  // of more, the nearest
};

struct MarksOnScreen {
  std::vector<PlacedMark> marks;
  std::size_t looked_at = 0;  // knots that were projected
};

// Returns the marks of knots and of the selection's handles, in no particular order. Finds the knots by the segment
// tree from near to far, if `derived` is of this document.
MarksOnScreen marks_on_screen(const world::Document& document, const sim::DerivedTrack& derived,
                              const world::Settings& settings, const View& view, const SelectionLookup& selected,
                              const MarkChoice& choice);

// True if `a` is drawn over `b`: handles over knots, then the nearer one, then the earlier in the track.
bool covers(const PlacedMark& a, const PlacedMark& b);

// Returns the knots whose handles are shown: the selected one, or both of the selected segment.
std::vector<world::Entity> knots_with_handles(const world::Document& document, const world::Settings& settings);

}  // namespace coaster::view
