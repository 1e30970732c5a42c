// Makes joints of a document G2 by the least movement of control points (curve/g2.h), within what knots can be, and
// checks the result after rounding. Pure functions of the document; the commands are in perform_joints.cpp.
#pragma once

#include <string>
#include <vector>

#include "base/status.h"
#include "world/document.h"

namespace coaster::edit {

// What may move: the knot's place, direction and handle lengths (a joint that is C1 stays C1; an automatic one becomes
// aligned), and the two handles of its neighbours that face it, along their lines, where the neighbour is aligned and
// not C1. The knot stays in its place beside an automatic neighbour, whose shape would follow. What holds afterwards:
// the joint is G2 to the tolerance of curve/continuity.h; the neighbours' joints have at least the geometric and
// parametric class they had; handle lengths and coordinates are within their limits; no control point moves further
// than half the shorter of the two control polygons. Else nothing is changed and the status says why. `index` is the
// knot's place in track.knots. A joint that is G2 already stays as it is. `movement`, when not null, gets metres: the
// root of the summed squares.
base::Status make_g2(world::Document& document, std::size_t index, double* movement = nullptr);

struct RefusedJoint {
  world::Entity knot;
  std::string reason;
};
struct RepairReport {
  int changed = 0;                    // joints that were not G2 and are now
  int already = 0;                    // joints that were G2, and are
  double movement = 0;                // m, root of the summed squared movements of all control points
  std::vector<RefusedJoint> refused;  // in track order; they are as smooth as before
};
// Every joint of the track in turn. Done in two ways, of which the one that makes more joints G2 is kept, or at equal
// numbers the one that moves less: (1) along the track once, joints that are G2 already staying so; (2) sweeps to and
// fro in which a repair may disturb its neighbours until all agree (at most kMostSweeps). Linear in the number of
// joints: about 0.2 ms a joint.
RepairReport make_all_g2(world::Document& document);
inline constexpr int kMostSweeps = 24;

}  // namespace coaster::edit
