// Shared parts of the laboratory's pictures: lines and arrows of constant size on screen, and the track that is close
// enough for detail.
#pragma once

#include <span>
#include <vector>

#include "view/overlay.h"

namespace coaster::view {

// Returns pixels per metre perpendicular to the line of sight at a point; 0 behind the eye.
class PixelScale {
 public:
  explicit PixelScale(const View& view);
  double operator()(glm::dvec3 at) const;

 private:
  glm::dvec3 eye_, forward_;
  double focal_px_;
  bool parallel_;
};

inline std::uint32_t faded(std::uint32_t rgba, std::uint32_t alpha) { return (rgba & 0xffffff00u) | alpha; }

inline void add_line(glm::dvec3 from, glm::dvec3 to, float width_px, std::uint32_t rgba, Overlay& overlay) {
  overlay.lines.push_back({glm::vec3(from), glm::vec3(to), width_px, rgba});
}

inline void add_disc(glm::dvec3 at, float radius_px, std::uint32_t rgba, Overlay& overlay) {
  overlay.marks.push_back({glm::vec3(at), radius_px, rgba, MarkShape::disc});
}

// Returns the selected segment, or the segments at the selected knot.
std::vector<world::Entity> selected_segments(const world::Document& document, world::Entity selected);

// Returns the point `height` metres above the rails at a distance along the track.
glm::dvec3 over_rails(const sim::Derived& derived, double distance, double height);

// Adds an arrow from `from` along the unit `direction`, `length` metres long. Its head, two barbs that face the eye, is
// omitted if the arrow points along the view.
void add_arrow(glm::dvec3 from, glm::dvec3 direction, double length, const View& view, float width_px,
               std::uint32_t rgba, Overlay& overlay);

// Adds a round sign of constant size on screen that faces the eye: a disc with dark dots at `glyph`, in pixels to the
// right and up.
void add_sign(glm::dvec3 at, std::uint32_t rgba, std::span<const glm::dvec2> glyph, const View& view, float scale,
              Overlay& overlay);

// Adds a broad line over the rails between two distances along the track, m, in `pieces`.
void add_band(const sim::Derived& derived, double from, double to, int pieces, float width_px, std::uint32_t rgba,
              Overlay& overlay);

// A segment that may be visible; segments outside the picture are not listed.
struct SeenSegment {
  std::size_t index = 0;    // into derived.order
  double px_per_metre = 0;  // at its nearest point
  double length_px = 0;
};
std::vector<SeenSegment> seen_segments(const sim::Derived& derived, const View& view);

}  // namespace coaster::view
