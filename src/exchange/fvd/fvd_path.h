// The heartline of a section of an openFVD project, by integration.
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
  sim::ElementCurve curve;    // of the heartline, with a point each 0.25 m at most
  std::vector<double> at;     // m, s or degrees that the functions count, by point
  std::vector<double> twist;  // degrees to the right per m, s or degree against the frame of least rotation, by point
  double speed = 0;           // m/s at the end
  std::string stopped;        // why it ends early; else empty
};

inline constexpr double kLongestFvd = 2000;  // m, of a section

// Joins the section's functions from what there is at the start, and integrates it to its end in steps of 5 cm at most.
// A turn without a lead-in begins within 1 m. Bezier sections and pieces without points stop at once. Positions are
// within a millimetre of a path in closed form after 100 m.
FvdPath fvd_path(const FvdTrack& track, FvdSection& section, const FvdStart& start);

}  // namespace coaster::exchange
