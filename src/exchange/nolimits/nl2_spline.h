// The curve of a NoLimits 2 element as cubic Béziers: runs of vertices between strict ones are clamped uniform cubic
// B-splines. Its corners are rounded: a track of the document has one direction at every knot. Its rolls: the knots
// that a track needs to match a file's rolls, and the rolls that a file needs to reproduce a track's frames.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include <glm/glm.hpp>

#include "curve/cubic.h"
#include "sim/shape/derived_track.h"

namespace coaster::exchange {

struct SplineVertex {
  glm::dvec3 position{0};  // m
  bool strict = false;     // ends a run of vertices: the curve passes through it
  double weight = 1;       // > 0; of a rational B-spline
};

using Bezier = std::array<glm::dvec3, 4>;  // control points, m
glm::dvec3 point(const Bezier& b, double t);
glm::dvec3 slope(const Bezier& b, double t);  // the derivative
// Returns the part between two parameters, 0 <= from < to <= 1. An end that is not cut stays exactly the same.
Bezier part(const Bezier& b, double from, double to);
// Return the unit direction of travel at the start and at the end; zero if the control points are within 0.1 mm.
glm::dvec3 start_direction(const Bezier& b);
glm::dvec3 end_direction(const Bezier& b);
// Returns the curve as a cubic of the document, rounded to float.
curve::Cubic in_float(const Bezier& b);

struct SplinePiece {
  Bezier curve;
  std::size_t vertex = 0;  // the vertex at or near the start, for messages
  double off = 0;          // m, from the rational curve
};

inline constexpr double kRationalOff = 0.0005;  // m

// Returns the curve in the order of travel, exact to rounding in double, or within kRationalOff where
// the weights of a run differ. A run of vertices goes from one strict vertex
// to the next; the first and the last vertex always end one. A run of n vertices is a uniform B-spline of degree
// min(3, n - 1) with clamped ends: two vertices are a straight line, three a parabola, four a Bézier. Needs 2 vertices.
std::vector<SplinePiece> spline_pieces(std::span<const SplineVertex> vertices);

// The rails at a distance along the track, for both NoLimits 2 formats.
struct PlaceOnTrack {
  glm::dvec3 position;
  curve::Frame frame;
};
PlaceOnTrack place_on(const sim::DerivedTrack& derived, double distance);
inline constexpr double kCornerOff = 0.03;    // m, the largest distance of a fillet from the corner it replaces
inline constexpr double kSharpest = 90;       // degrees; sharper corners are rejected
inline constexpr double kTurnedOff = 0.0001;  // m; handles are turned if that moves the curve by no more

struct Corner {
  std::size_t vertex = 0;
  double angle = 0;  // rad between the directions before and after it
  double off = 0;    // m, the largest distance of the fillet from the original curve
};

// Replaces each corner by a fillet, a cubic with the directions of its two ends. It takes at most 45 % of the length of
// either neighbour. On a closed track the joint of the last piece and the first is also checked. Adds the corners to
// `corners`; those sharper than kSharpest are unchanged.
std::vector<SplinePiece> round_corners(const std::vector<SplinePiece>& pieces, bool closed,
                                       std::vector<Corner>& corners);

// Returns the first place where the curve turns by more than kSharpest within kCornerOff on either side, between
// corners: a cusp, or nearly one. Vertices that lead back on one line make cusps.
std::optional<Corner> find_fold(const std::vector<SplinePiece>& pieces, bool closed);

struct ElementRoll {
  glm::dvec3 up{0, 1, 0};  // unit
  double coord = 0;        // fraction of the track's length, 0..1
  bool strict = false;     // the angle's rate is 0 here
};

struct RollPoint {
  double s = 0;         // m along the track
  double angle = 0;     // rad against the rotation-minimising frame
  bool strict = false;  // the rate is 0 here
};

// The cubic spline through roll points. The rate is 0 at the first, the last and every strict point (NoLimits 2 counts
// strict points twice), the second derivative is continuous at the others. Constant before the first and after the
// last.
class RollSpline {
 public:
  explicit RollSpline(std::vector<RollPoint> points);  // ascending by s; at least one
  struct Value {
    double angle = 0, rate = 0;  // rad, rad/m
  };
  Value at(double s) const;

 private:
  std::vector<RollPoint> points_;
  std::vector<double> rates_;  // rad/m, at the points
};

inline constexpr double kRollSnap = 0.03;       // m: a roll this close to a knot belongs to it
inline constexpr double kRollApart = 0.14;      // m: a roll nearer to the one before is ignored, except at knots
inline constexpr double kRollTolerance = 0.05;  // degrees: a roll that the track matches this closely needs no knot
inline constexpr double kBetweenRolls = 0.1;    // degrees: the same for the spline between rolls

// A position at which the track gets a knot.
struct KnotPosition {
  std::size_t piece = 0;
  double t = 0, s = 0;           // parameter of the piece; m along the track
  std::optional<glm::dvec3> up;  // if there is a roll here
  double angle = 0;              // rad of the track against the rotation-minimising frame; 0 everywhere without rolls
  double spin = 0;               // rad/m, of the knot
};

// Returns the start of every piece, the end of an open track, and the rolls between them that need a knot, in the order
// of travel. Between rolls the angle to the rotation-minimising frame is a RollSpline; that of a closed track without a
// roll at its start runs through the seam. Stops have the spins with which the track follows it best. A closed track
// also gets a stop after its lap, with the angle there. Without rolls no stop has an `up`; with them every one does.
std::vector<KnotPosition> stops_of(std::span<const Bezier> pieces, bool closed, std::vector<ElementRoll> rolls);
inline constexpr double kRollError = 0.25;    // degrees, of the track between printed rolls
inline constexpr double kSplineError = 0.05;  // degrees, the same, read as NoLimits 2 does
inline constexpr double kRollStep = 0.15;     // m, the shortest distance of printed rolls within a segment

// Returns where rolls are printed, m along the track, ascending from 0 to its length: at every knot, and between them
// as many as keep the track's frame within kSplineError of the RollSpline through them, and within kRollError of two
// other interpretations: the angle to the rotation-minimising frame linear, or `up` interpolated between neighbours.
// Rolls closer than kRollStep are not added.
std::vector<double> roll_places(const sim::DerivedTrack& derived);

}  // namespace coaster::exchange
