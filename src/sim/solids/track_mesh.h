// The swept solid of one segment: two rails, a spine and ties, and what its equipment puts on them. Pure functions of
// the shape; the vertex-buffer cache calls them only when the shape's build number or the equipment changes.
#pragma once

#include <optional>
#include <vector>

#include "sim/shape/derived.h"
#include "sim/solids/mesh.h"

namespace coaster::sim {

inline constexpr double kGauge = 1.2;         // m between the rails' axes
inline constexpr double kRailRadius = 0.12;   // m
inline constexpr double kSpineRadius = 0.28;  // m
inline constexpr double kSpineDrop = 0.62;    // m below the rails' plane
inline constexpr double kTieSpacing = 1.5;    // m between ties, about: a whole number fits a segment
inline constexpr int kRailSides = 8, kSpineSides = 12;
inline constexpr int kMaxRings = 400;  // of a segment
inline constexpr double kSagitta =
    0.01;  // m, that rails cut off the curve between rings, unless there are kMaxRings of them

// The frame at arc length s of a segment. At both ends it is the knot's own: neighbours have the same bits there.
Ring ring_at(const SegmentShape& shape, double s);

// Distances from the segment's start at which rings stand, from 0 to its length: by kSagitta, 6 degrees of twist and at
// most 4 m where it bends, 2 to kMaxRings of them; a segment that neither bends nor twists by a quarter of a degree
// has 2.
std::vector<double> ring_places(const SegmentShape& shape);
std::vector<Ring> rings_of(const SegmentShape& shape);

// Rails, spine and ties. The rings at both ends depend on the knots alone, so neighbours meet bit for bit. Tubes have
// smooth normals and are closed at both ends. Replaces what `mesh` holds. A segment without length gives tubes without
// length, never NaN.
void sweep_track(const SegmentShape& shape, Mesh& mesh);

// Adds what a kind of equipment shows: a chain and a walkway with a handrail on a lift, rows of fins on brakes and
// blocks, blocks of a linear motor on a launch, platforms beside the track in a station. Walkways and platforms are
// left out where the track is too steep or too much on its side to stand on. Nothing for a segment without length.
void add_fittings(const SegmentShape& shape, world::EquipmentKind kind, Mesh& mesh);

}  // namespace coaster::sim
