// The swept solid of one segment: rails, spine and ties of the coaster's kind, and its equipment. Pure functions of the
// shape; the vertex-buffer cache calls them only if the shape's build number or the equipment changes.
#pragma once

#include <vector>

#include "sim/shape/detail_limits.h"
#include "sim/solids/coaster_form.h"

namespace coaster::sim {

class Ground;

// m, largest deviation of rails from their line between rings, unless there are SolidsDetail::most_rings.
inline constexpr double kSagitta = 0.01;

// Returns the rails and the curve's frame at arc length s of a segment. At both ends the frame is the knot's own:
// neighbours have the same bits there.
Ring ring_at(const SegmentShape& shape, double s);

// Returns the distances of the rings from the segment's start, from 0 to its length: by kSagitta, 6 degrees of twist
// and at most 4 m where it bends, 2 to `most` of them. A segment that bends and twists by less than a quarter of a
// degree has 2.
std::vector<double> ring_places(const SegmentShape& shape, int most = kMaxRings);
std::vector<Ring> rings_of(const SegmentShape& shape, int most = kMaxRings);
// Returns the rings at the middles of equal parts of about `spacing` metres.
std::vector<Ring> spaced_rings(const SegmentShape& shape, double spacing);
// Returns rings that are upright for any roll: left is level, up is perpendicular to it and to the track.
std::vector<Ring> level(std::vector<Ring> rings);

// Returns a unit vector that is level and across the track; on vertical track the level part of its left.
glm::dvec3 level_side(const curve::Frame& frame);

// Returns the form of the kind that the shape's track is of.
inline const CoasterForm& form_of(const SegmentShape& shape) { return form_of(shape.key.kind); }

// Builds rails, spine and ties. The rings at both ends depend on the knots alone, so neighbours meet bit for bit. Tubes
// have smooth normals and are closed at `caps`. Replaces the contents of `mesh`. A segment of zero length gives tubes
// of zero length, never NaN. `detail` may leave out the ties, or everything.
void sweep_track(const SegmentShape& shape, Mesh& mesh, Caps caps = {}, const SolidsDetail& detail = {});

// Returns the rings at which the ties of a segment are; none if it is very short or `detail` leaves them out.
std::vector<Ring> tie_rings(const SegmentShape& shape, const SolidsDetail& detail);

// The parts of a swept solid: a mesh between two rings, around the origin with forward +X, up +Y, left -Z. Every vertex
// has x = 0, or is so far along from its ring, the first (along 0) or the second one (along 1). Sweeping `tubes` from
// ring to ring, `caps` over the first and the last one and `tie` over half_tie of the form to both sides of a tie's
// ring gives sweep_track().
struct TrackPieces {
  Mesh tubes;  // rails and spine; `coarse` for distant views
  Mesh caps;   // closes them, seen against the direction of travel
  Mesh tie;
};
TrackPieces track_pieces(const CoasterForm& form);

// Adds the solids of a kind of equipment: a chain and a walkway with a handrail on a lift, rows of fins on brakes and
// blocks, blocks of a linear motor on a launch, platforms next to the track in a station. Walkways and platforms are
// left out where the track is too steep or too banked. Platforms stand on `ground`; null: on the plane y = 0. Adds
// nothing for a segment of zero length.
void add_fittings(const SegmentShape& shape, world::EquipmentKind kind, Mesh& mesh, const SolidsDetail& detail = {},
                  const Ground* ground = nullptr);

}  // namespace coaster::sim
