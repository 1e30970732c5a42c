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
};

inline constexpr double kRollSnap = 0.03;       // m: a roll this close to a knot belongs to it
inline constexpr double kRollTolerance = 0.05;  // degrees: a roll that the track matches this closely needs no knot

// A position at which the track gets a knot.
struct Stop {
  std::size_t piece = 0;
  double t = 0, s = 0;           // parameter of the piece; m along the track
  std::optional<glm::dvec3> up;  // if there is a roll here
  double angle = 0;              // rad of the track against the rotation-minimising frame; 0 everywhere without rolls
  double spin = 0;               // rad/m, of the knot
};

// Returns the start of every piece, the end of an open track, and the rolls between them that need a knot, in the order
// of travel. Between rolls the angle to the rotation-minimising frame is linear along the track; before the first and
// after the last roll of an open track it is constant. Stops have the spins with which the track matches the rolls
// between them best, close to the automatic ones if there are none. A closed track also gets a stop after its lap, with
// the angle there. Without rolls no stop has an `up`; with them every one does.
std::vector<Stop> stops_of(std::span<const Bezier> pieces, bool closed, std::vector<ElementRoll> rolls);

inline constexpr double kRollError = 0.25;  // degrees, of the track between printed rolls
inline constexpr double kRollStep = 0.15;   // m, the shortest distance of printed rolls within a segment

// Returns where rolls are printed, m along the track, ascending from 0 to its length: at every knot, and between them
// as many as keep the track's frame within kRollError for three interpretations between rolls: linear, or a cubic
// spline with rate 0 at both ends (both by the angle to the rotation-minimising frame), or `up` interpolated between
// neighbours. Rolls closer than kRollStep are not added.
std::vector<double> roll_places(const sim::Derived& derived);

}  // namespace coaster::exchange
