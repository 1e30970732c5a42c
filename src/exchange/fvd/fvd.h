// Import of openFVD and FVD++ projects (.fvd): their content, with every number checked, its functions, and the path of
// a section.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <glm/glm.hpp>

#include "base/status.h"
#include "exchange/own/track_file.h"
#include "sim/plan/element_path.h"
#include "world/force_program.h"

namespace coaster::exchange {

// The shape of a piece of a function between its start and its end: docs/forces.md has the formulas.
enum class FvdShape : std::uint8_t {
  linear,
  quadratic,
  cubic,
  quartic,
  quintic,
  sinusoidal,
  plateau,
  to_zero,   // rolls to the horizon
  free_form  // its points are not in the file
};

struct FvdPiece {
  FvdShape shape = FvdShape::linear;
  double from = 0, to = 0;         // s, m or degrees of turning
  double start = 0, change = 0;    // value at its start; change to its end or to its peak
  double form = 0;                 // shape of quadratic to quintic pieces and plateaus
  double centre = 0, tension = 0;  // shift of its middle; steepness there
  bool follows = false;            // it ends where the section does
};
using FvdFunction = std::vector<FvdPiece>;  // ascending, at least one
enum class FvdKind : std::uint8_t { straight, curved, forced, geometric, bezier };

struct FvdSection {
  FvdKind kind = FvdKind::straight;
  std::string name;
  bool free_speed = true;                                                  // else the train keeps `speed`
  double speed = 0;                                                        // m/s
  double angle = 0, radius = 0, direction = 0, lead_in = 0, lead_out = 0;  // curved: degrees, m
  bool upright = false;      // roll is relative to the horizon, not to a rotation-minimising frame
  bool by_distance = false;  // forced, geometric: functions of m, not of s
  FvdFunction roll;          // degrees per second (forced and geometric by distance: per metre), positive to the left
  FvdFunction vertical;      // forced: g; geometric: degrees of pitch per second or metre
  FvdFunction lateral;       // forced: g to the left; geometric: degrees of yaw to the left
};

struct FvdTrack {
  std::string name;
  glm::dvec3 position{0};               // m, of the heartline's start
  double roll = 0, pitch = 0, yaw = 0;  // degrees there, to the left, up and to the left of -Z
  double speed = 0;                     // m/s at the start
  double heart = 0;                     // m from the rails up to the heartline
  double friction = 0, resistance = 0;  // share of the weight; 1/m
  std::vector<FvdSection> sections;
  std::size_t others = 0;  // further tracks of the project, which are not read
};

inline constexpr std::size_t kMostFvdSections = 500, kMostFvdPieces = 500;  // sections of a track, pieces of a function

// Reads the first track. Code::bad_file with "NAME: error: at byte N: expected ..., found ..." for a file that ends
// early, versions other than v0.30 and v0.77, numbers that are not finite or beyond the limits of a track, and pieces
// that do not ascend.
base::Result<FvdTrack> read_fvd(std::string_view bytes, std::string_view name);

// The start of a piece that rolls to the horizon: the roll in degrees to the left, and the derivative of the roll's
// rate by the fraction of the piece.
struct FvdLevelling {
  double roll = 0, slope = 0;
};

// Returns a piece's value at x, clamped to the piece. `levelling` is used only for pieces `to_zero`.
double value_of(const FvdPiece& piece, double x, const FvdLevelling& levelling = {});

// Returns the piece for x, beyond the end the last one; and its value there.
const FvdPiece& piece_at(const FvdFunction& function, double x);
inline double value_at(const FvdFunction& function, double x) { return value_of(piece_at(function, x), x); }

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

// Returns the first track of the project, on its heartline. A forced section with a free speed becomes, if there is no
// heartline, a force section with keys that follow its functions within 0.01 g. All others become hand-shaped ones,
// within 1 cm of their integrated path; a section with a constant speed gets a lift, or a brake if the train arrives
// faster. If a section cannot be read, the track ends before it, with a warning. docs/forces.md has layout,
// formulas and what is left out. Errors: those of read_fvd, and Code::bad_file if no segment is left, with the section
// and the reason.
base::Result<LoadedTrack> parse_fvd(std::string_view bytes, std::string_view name);

}  // namespace coaster::exchange
