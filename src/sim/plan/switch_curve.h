// Makes a track's cubics the rails or the heartline (world::TrackCurve) without moving its rails.
#pragma once

#include <vector>

#include "base/status.h"
#include "sim/shape/derived.h"

namespace coaster::sim {

inline constexpr double kRailsBound = 0.01;  // m, largest distance of the rails from where they were

// A position on a track: parameter t of a segment.
struct CurvePlace {
  world::Entity segment;
  double t = 0;
};

struct SwitchedCurve {
  world::Document document;
  Derived shapes;        // of `document`
  double max_error = 0;  // m, of the rails
  int added = 0;         // knots

  // Returns where a position of the track `former` is now: beside it.
  CurvePlace place(const Derived& former, CurvePlace at) const;

  // Piece k of a former segment begins at its parameter `from` and is a segment now.
  struct Piece {
    double from = 0;
    world::Entity segment;
  };
  world::Pool<std::vector<Piece>> pieces;  // by former segment, in order
};

// Returns the document with the other curve, its rails within kRailsBound and their `up` within a quarter of a degree.
// Every knot moves along its `up`, keeps its name, and gets the direction of the new curve there in closed form, and
// handles with the new curve's curvature at both ends of a segment (element_fit.h); a segment that misses the bound is
// halved. Joints with handles of two lengths become aligned.
// Trains keep their positions, equipment its segments. Refused, with the place, where the new curve would fold or the
// bound is not met. About 0.1 ms per segment.
base::Result<SwitchedCurve> switch_curve(const world::Document& document, const Derived& derived, world::TrackCurve to);

}  // namespace coaster::sim
