// Integrates the heartline of a section of an openFVD project.
#pragma once

#include <string>

#include "exchange/fvd/fvd_function.h"
#include "sim/plan/element_path.h"

namespace coaster::exchange {

// A train at the start of a section.
struct FvdStart {
  glm::dvec3 position{0}, forward{0, 0, -1}, up{0, 1, 0};  // m, unit, unit and perpendicular
  double speed = 10;                                       // m/s
};

struct FvdPath {
  sim::ElementCurve curve;    // heartline, with a point every 0.25 m or less
  std::vector<double> at;     // by point: m, s or degrees, the argument of the functions
  std::vector<double> twist;  // by point: degrees to the right per m, s or degree against the rotation-minimising frame
  double speed = 0;           // m/s at the end
  std::string stopped;        // why it ends early; empty if it does not
};

inline constexpr double kLongestFvd = 2000;  // m, of a section

// Joins the section's functions to the start, and integrates it to its end in steps of at most 5 cm. The train moves on
// the rails, a heartline below the path. Without a heartline a turn without a lead-in gets one of 1 m. Bezier sections
// and pieces without points stop at once. Positions are within a millimetre of a path in closed form after 100 m.
FvdPath fvd_path(const FvdTrack& track, FvdSection& section, const FvdStart& start);

}  // namespace coaster::exchange
