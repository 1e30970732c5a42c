// Makes joints of a document G2 with the least movement of control points (curve/g2.h), within the limits of knots, and
// checks the rounded result. Pure functions of the document; the commands are in knots.cpp.
#pragma once

#include <string>
#include <vector>

#include "base/status.h"
#include "world/document.h"

namespace coaster::edit {

// Makes a joint G2. May move: the knot's position, direction and handle lengths (a joint that is C1 stays C1; an
// automatic one becomes aligned), and the two handles of its neighbours that face it, along their lines, if the
// neighbour is aligned and not C1. The knot does not move next to an automatic neighbour, whose shape would follow.
// Afterwards the joint is G2 to the tolerance of curve/continuity.h; the neighbours' joints keep at least their
// geometric and parametric class; handle lengths and coordinates are within their limits; no control point moves
// farther than half the shorter of the two control polygons. Otherwise nothing changes and the status says why. `index`
// is the knot's index in track.knots. A joint that is already G2 does not change. `movement`, if not null, receives the
// root of the summed squared movements, m.
base::Status make_g2(world::Document& document, std::size_t index, double* movement = nullptr);

struct RefusedJoint {
  world::Entity knot;
  std::string reason;
};
struct RepairReport {
  int changed = 0;                    // joints that became G2
  int already = 0;                    // joints that were G2 before
  double movement = 0;                // m, root of the summed squared movements of all control points
  std::vector<RefusedJoint> refused;  // in track order; their continuity is unchanged
};
// Repairs every joint of the track in turn by two methods, and keeps the result with more G2 joints, or with less
// movement if equal: (1) once along the track, keeping joints that are already G2; (2) sweeps to and fro in which a
// repair may disturb its neighbours until all agree (at most kMostSweeps). Linear in the number of joints: about 0.2 ms
// per joint.
RepairReport make_all_g2(world::Document& document);
inline constexpr int kMostSweeps = 24;

}  // namespace coaster::edit
