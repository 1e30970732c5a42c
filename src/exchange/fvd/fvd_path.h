// The functions and the path of a section of an openFVD project: evaluates functions, makes force keys that follow one,
// and integrates the heartline.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "exchange/fvd/fvd_file.h"
#include "sim/plan/element_path.h"
#include "world/force.h"

namespace coaster::exchange {

// The start of a piece that rolls to the horizon: the roll in degrees to the left, and the derivative of the roll's
// rate by the fraction of the piece.
struct FvdLevelling {
  double roll = 0, slope = 0;
};

// Returns a piece's value at x, clamped to the piece. `levelling` is used only for pieces `to_zero`.
double value_of(const FvdPiece& piece, double x, const FvdLevelling& levelling = {});

// Returns the piece for x; beyond the end the last one.
const FvdPiece& piece_at(const FvdFunction& function, double x);

// Shifts each piece to start with the value at which the previous one ends, as openFVD does when it opens a file, the
// first with `start`, and sets the ends of pieces that follow the section's end.
void join_pieces(FvdFunction& function, double start, double length);

// Returns the end of the section: that of the shortest function without a piece that follows it. 0: none.
double shared_length(std::span<const FvdFunction* const> functions);

// Returns keys whose curve follows f over [0, length] within `tolerance`, at least `gap` apart: at the given positions
// where f or its derivative jumps, the curve cuts the corner over one gap. Values are clamped to `limit`. If more than
// world::kMostForceKeys are needed, the tolerance is doubled until they suffice.
std::vector<world::ForceKey> keys_along(const std::function<double(double)>& f, std::vector<double> corners,
                                        double length, double tolerance, double gap, double limit);

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
