// Rolls of NoLimits 2 elements: the knots that a track needs to match a file's rolls, and the rolls that a file needs
// to reproduce a track's frames.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "exchange/nolimits/nl2_spline.h"
#include "sim/shape/derived.h"

namespace coaster::exchange {

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
struct Stop {
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
std::vector<Stop> stops_of(std::span<const Bezier> pieces, bool closed, std::vector<ElementRoll> rolls);

inline constexpr double kRollError = 0.25;    // degrees, of the track between printed rolls
inline constexpr double kSplineError = 0.05;  // degrees, the same, read as NoLimits 2 does
inline constexpr double kRollStep = 0.15;     // m, the shortest distance of printed rolls within a segment

// Returns where rolls are printed, m along the track, ascending from 0 to its length: at every knot, and between them
// as many as keep the track's frame within kSplineError of the RollSpline through them, and within kRollError of two
// other interpretations: the angle to the rotation-minimising frame linear, or `up` interpolated between neighbours.
// Rolls closer than kRollStep are not added.
std::vector<double> roll_places(const sim::Derived& derived);

}  // namespace coaster::exchange
