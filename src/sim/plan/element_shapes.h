// The ideal curves of the elements: one function per row of world::elements(), in element_shapes*.cpp.
#pragma once

#include <string>
#include <vector>

#include "base/portable_math.h"
#include "sim/plan/element_path.h"
#include "world/components.h"
#include "world/element.h"

namespace coaster::sim {

// The open end of a track, at which an element begins.
struct TrackEnd {
  glm::dvec3 position{0, 2, 0}, forward{1, 0, 0}, up{0, 1, 0};  // m, unit, unit and perpendicular
  glm::dvec3 curvature{0};                                      // 1/m, at the end of the track's last segment
  double spin = 0;                                              // rad/m
  friend bool operator==(const TrackEnd&, const TrackEnd&) = default;
};

// Equipment of an element, from the end of the previous part, or else from the start of the lead-in.
struct EquippedPart {
  std::size_t to = 0;  // index of the curve's point where it ends
  world::Equipment equipment;
};

// A curve, or the reason why there is none. Values of the element that had to be limited are changed, each with a line
// that contains the word "limit".
struct ElementShape {
  ElementCurve curve;
  std::vector<EquippedPart> equipped;
  std::string refusal;  // empty: there is a curve
};

// Steeper ends have no heading for a curve to turn; only a straight can continue them.
inline constexpr double kSteepestEnd_deg = 80;
// 1/m: an end that bends less than the first counts as straight, which steps the force by 0.008 g at 40 m/s; an end
// that bends more than the second accepts no element.
inline constexpr double kStraightEnd = 5e-5;
inline constexpr double kSharpestEnd = 0.5;
// The easing of curvature turns by at most this angle, over at most kLongestEase.
inline constexpr double kEaseAngle = 0.175, kLongestEase = 12;  // rad, m

// Returns the curve of an element whose values are within the limits of its table. It begins with the end's direction
// and curvature, and ends straight.
ElementShape element_shape(world::Element& element, const TrackEnd& end, std::vector<std::string>& lines);

// Returns "Raised height from 3 m to the limit of 5.2 m".
std::string beyond_limit(const world::ElementParameter& parameter, double value, double limit);
// Each function adds its pieces to a path whose axes are the heading, +Y and the left, from a point without curvature.
// `slope`: the angle above the horizon there, rad; 0 for elements that begin level.
struct ShapeTask {
  world::Element& element;
  ElementPath& path;
  double slope;
  std::vector<std::string>& lines;
  std::vector<EquippedPart>& equipped;

  double value(std::string_view parameter) const { return world::value_of(element, parameter); }
  double radians(std::string_view parameter) const { return base::radians(value(parameter)); }
  double side() const { return element.right ? 1 : -1; }
  // Sets a value to the limit and adds a line as beyond_limit() with ": REASON.".
  void give_way(std::string_view parameter, double limit, std::string_view reason);
  // Return a value, after it has given way to the limit if it is less, or more.
  double at_least(std::string_view parameter, double limit, std::string_view reason);
  double at_most(std::string_view parameter, double limit, std::string_view reason);
};
void add_curve(ShapeTask& task);
void add_helix(ShapeTask& task);
void add_climb_or_dive(ShapeTask& task);
void add_camelback(ShapeTask& task);
void add_loop(ShapeTask& task);
void add_corkscrew(ShapeTask& task);
void add_s_bend(ShapeTask& task);
void add_overbanked_turn(ShapeTask& task);
void add_bunny_hops(ShapeTask& task);
void add_zero_g_roll(ShapeTask& task);
void add_immelmann(ShapeTask& task);
void add_dive_loop(ShapeTask& task);
void add_cobra_roll(ShapeTask& task);
void add_brake_run(ShapeTask& task);

}  // namespace coaster::sim
