// Changes which line a track's cubics describe, the rails or the heartline (world::TrackCurve), without moving the
// rails.
#pragma once

#include <vector>

#include "base/status.h"
#include "sim/shape/derived_track.h"

namespace coaster::sim {

inline constexpr double kRailsBound = 0.01;  // m, largest distance of the rails from their former position

// A position on a track: parameter t of a segment.
struct CurvePlace {
  world::Entity segment;
  double t = 0;
};

struct SwitchedCurve {
  world::Document document;
  DerivedTrack shapes;   // of `document`
  double max_error = 0;  // m, largest distance of the rails
  int added = 0;         // added knots

  // Returns the position on the new track that corresponds to one on the track `former`.
  CurvePlace place(const DerivedTrack& former, CurvePlace at) const;

  // Piece k of a former segment begins at its parameter `from` and is now a segment.
  struct Piece {
    double from = 0;
    world::Entity segment;
  };
  world::Pool<std::vector<Piece>> pieces;  // by former segment, in track order
};

// Returns the document with the other curve, its rails within kRailsBound and their `up` within a quarter of a degree.
// Every knot moves along its `up`, keeps its name, and gets the direction of the new curve there in closed form, and
// handles with the new curve's curvature at both ends of a segment (element_fit.h); a segment that misses the bound is
// halved. Joints with handles of two lengths become aligned. Trains keep their positions, equipment its segments.
// Refused, with the position, if the new curve would fold or the bound is not met. About 0.1 ms per segment.
base::Result<SwitchedCurve> switch_curve(const world::Document& document, const DerivedTrack& derived,
                                         world::TrackCurve to);

}  // namespace coaster::sim
