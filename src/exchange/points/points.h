// Lists of points, as courses and programs of computer graphics write them: three numbers a row (docs/track-format.md).
#pragma once

#include <string_view>
#include <vector>

#include "exchange/own/import_options.h"
#include "exchange/own/track_file.h"

namespace coaster::exchange {

inline constexpr std::size_t kMaxPoints = world::kMaxKnots;
inline constexpr double kLeastSmooth = 0.02, kMostSmooth = 100;  // m
inline constexpr double kMostScale = 1e6;                        // metres a unit
inline constexpr double kNearest = 0.029;                        // m

// The points in the units and axes of the file.
struct PointList {
  std::vector<glm::dvec3> points;  // 2 or more, neighbours differ; a closed list does not repeat the first one
  std::size_t repeated = 0;        // points equal to the one before, left out
  bool closed = false;             // the first point again at the end, or as near as points usually are
  double length = 0;               // of the polyline
  glm::dvec3 low{0}, high{0};      // bounds
};

// Reads a list of 2 to kMaxPoints. Errors are Code::bad_file: "NAME:LINE: error: expected ..., found ...".
base::Result<PointList> read_points(std::string_view text, std::string_view name);

// True if the first rows are those of a list: three numbers, perhaps below a count or three names. `sure`: not if there
// are only a count or names.
bool is_points(std::string_view text, bool sure = true);

// Returns `import` with the axis and the unit that it leaves open. Up is y, or z if the list is much less high than
// wide then, except for a profile: an open list in the plane of x and y. The unit is a metre, or the power of ten that
// makes the track 300 m to 3 km long if metres would make it shorter than 30 m, longer than 20 km or higher than 600 m.
ImportOptions proposed(const PointList& list, ImportOptions import);

// Returns the file's point or extent with Y up.
glm::dvec3 with_y_up(glm::dvec3 of_file, world::Axis up);

// Parses a list and makes a track of it: a knot at each point whose handles are those of the Catmull-Rom spline, as
// exact as floats are, or with ImportOptions::smooth the fit of fewer knots to a smoothed list. Without trains. Points
// nearer than kNearest to the one before are left out: two handles of world::kMinHandle need more room.
base::Result<LoadedTrack> parse_points(std::string_view text, std::string_view name, const ImportOptions& import);

}  // namespace coaster::exchange
