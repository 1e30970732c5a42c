// The ideal curves of the elements: one function for each row of world::elements(), in sim/element_shapes*.cpp.
#pragma once

#include <string>
#include <vector>

#include "sim/plan/element_path.h"
#include "world/element.h"

namespace coaster::sim {

// Where an element goes on from: the open end of a track.
struct TrackEnd {
  glm::dvec3 position{0, 2, 0}, forward{1, 0, 0}, up{0, 1, 0};  // m, unit, unit and perpendicular
  glm::dvec3 curvature{0};                                      // 1/m, at the end of the track's last segment
  friend bool operator==(const TrackEnd&, const TrackEnd&) = default;
};

// A curve, or why there is none. Values of the element that had to give way are changed, each with a line that contains
// the word "limit".
struct ElementShape {
  ElementCurve curve;
  std::string refusal;  // empty: there is a curve
};

// Ends steeper than this have no heading that a curve could turn; only a straight goes on from them.
inline constexpr double kSteepestEnd_deg = 80;
// 1/m: an end that is as straight as the first counts as straight, well within what counts as G2 (curve/continuity.h:
// 1e-3); from one that bends more than the second nothing goes on.
inline constexpr double kStraightEnd = 5e-5;
inline constexpr double kSharpestEnd = 0.5;
// Easing turns by at most this, over at most kLongestEase.
inline constexpr double kEaseAngle = 0.175, kLongestEase = 12;  // rad, m

// `element` is within the limits of its table. The curve begins at the end with its direction and its curvature, and
// ends straight.
ElementShape element_shape(world::Element& element, const TrackEnd& end, std::vector<std::string>& lines);

// "height 3 m is beyond the limit of 5.2 m: REASON", and the value set to the limit.
void give_way(world::Element& element, std::string_view parameter, double limit, std::string_view reason,
              std::vector<std::string>& lines);

// Each adds its pieces to a path whose axes are the heading, +Y and the left, from a place without curvature. `slope`:
// the angle over the horizon there, rad; 0 for those that begin level.
struct ShapeTask {
  world::Element& element;
  ElementPath& path;
  double slope;
  std::vector<std::string>& lines;
};
void add_curve(ShapeTask& task);
void add_helix(ShapeTask& task);
void add_climb_or_dive(ShapeTask& task);
void add_camelback(ShapeTask& task);
void add_loop(ShapeTask& task);
void add_corkscrew(ShapeTask& task);

}  // namespace coaster::sim
