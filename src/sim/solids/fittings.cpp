// The solids of equipment on its segment's rails: chain, fins, motor blocks, walkway, platforms. Lengthwise parts run
// from joint to joint, so that a lift over several segments looks like one; rows of parts divide each segment evenly.
#include <algorithm>
#include <cmath>

#include "sim/solids/track_mesh.h"

namespace coaster::sim {
namespace {

using glm::dvec2;
using glm::dvec3;

constexpr double kShortestFitted = 0.5;  // m: on shorter segments nothing is shown

struct Fitting {
  const SegmentShape& shape;
  std::vector<Ring> rings;
  Mesh& mesh;
};

// Adds a block around (left, up) with half sides along forward, up and left.
void add_block(const Ring& at, dvec2 middle, dvec3 half, Part part, bool from_afar, Mesh& mesh) {
  add_box(at.place(middle), at.frame, half, part, at.along, from_afar, mesh);
}

// The bed between the rails: crossbars from arm to arm and a beam along the track on them.
constexpr double kBedTop = -0.17;
void add_bed(const Fitting& fitting, double half_width) {
  for (const Ring& at : spaced_rings(fitting.shape, kTieSpacing))
    add_block(at, {0, kBedTop - 0.11}, {0.04, 0.04, 0.36}, Part::tie, false, fitting.mesh);
  add_beam(fitting.rings, {-half_width, kBedTop - 0.07}, {half_width, kBedTop}, Part::tie, true, fitting.mesh);
}

// Adds a band with a ridge for each second link, in a trough.
void add_chain(const Fitting& fitting) {
  constexpr double kPitch = 0.30, kTroughHalf = 0.15;
  add_bed(fitting, kTroughHalf);
  for (const double side : {-1.0, 1.0}) {
    const double outer = side * kTroughHalf, inner = side * (kTroughHalf - 0.03);
    add_beam(fitting.rings, {std::min(outer, inner), kBedTop}, {std::max(outer, inner), kBedTop + 0.06}, Part::tie,
             false, fitting.mesh);
  }
  add_beam(fitting.rings, {-0.025, kBedTop}, {0.025, kBedTop + 0.055}, Part::chain, true, fitting.mesh);
  for (const Ring& at : spaced_rings(fitting.shape, kPitch)) {
    for (const double side : {-1.0, 1.0})
      add_block(at, {0.062 * side, kBedTop + 0.05}, {0.105, 0.05, 0.018}, Part::chain, false, fitting.mesh);
    add_block(at, {0, kBedTop + 0.05}, {0.03, 0.028, 0.055}, Part::chain, false, fitting.mesh);
  }
}

// Adds two rows of upright plates between the rails.
void add_fins(const Fitting& fitting) {
  add_bed(fitting, 0.22);
  for (const Ring& at : spaced_rings(fitting.shape, 0.9)) {
    for (const double side : {-1.0, 1.0}) {
      add_block(at, {0.13 * side, kBedTop + 0.125}, {0.38, 0.125, 0.018}, Part::fin, true, fitting.mesh);
      add_block(at, {0.13 * side, kBedTop + 0.03}, {0.30, 0.03, 0.05}, Part::chain, false, fitting.mesh);
    }
  }
}

// Adds pairs of blocks, with a slot between them for the train's fin.
void add_stators(const Fitting& fitting) {
  add_bed(fitting, 0.30);
  for (const Ring& at : spaced_rings(fitting.shape, 0.75)) {
    for (const double side : {-1.0, 1.0}) {
      add_block(at, {0.16 * side, kBedTop + 0.10}, {0.31, 0.10, 0.09}, Part::stator, true, fitting.mesh);
      add_block(at, {0.16 * side, kBedTop + 0.215}, {0.25, 0.015, 0.06}, Part::chain, false, fitting.mesh);
    }
  }
}

// Returns rings that are upright for any roll: left is level, up is perpendicular to it and to the track.
std::vector<Ring> level(std::vector<Ring> rings) {
  for (Ring& ring : rings) ring.frame.up = curve::perpendicular(ring.frame.forward, {0, 1, 0});
  return rings;
}

bool walkable(const std::vector<Ring>& rings, double most_slope, double least_up) {
  return std::all_of(rings.begin(), rings.end(), [&](const Ring& ring) {
    return std::abs(ring.frame.forward.y) <= most_slope && ring.frame.up.y >= least_up;
  });
}

// Adds posts and two rails over the outer edge of a floor at (left, up).
void add_handrail(const Fitting& fitting, const std::vector<Ring>& rings, dvec2 edge, double spacing, bool upright) {
  constexpr double kHeight = 1.05;
  for (const double height : {0.55, kHeight})
    add_beam(rings, edge + dvec2(-0.025, height - 0.025), edge + dvec2(0.025, height + 0.025), Part::support,
             height == kHeight, fitting.mesh);
  for (const Ring& at : upright ? level(spaced_rings(fitting.shape, spacing)) : spaced_rings(fitting.shape, spacing))
    add_block(at, edge + dvec2(0, 0.5 * kHeight), {0.025, 0.5 * kHeight, 0.025}, Part::support, false, fitting.mesh);
}

// Adds a walkway on brackets from the spine, on the left.
void add_walkway(const Fitting& fitting) {
  constexpr double kInner = 1.05, kOuter = 1.70, kFloor = -0.38;
  if (!walkable(fitting.rings, 0.82, 0.75)) return;
  add_beam(fitting.rings, {kInner, kFloor - 0.05}, {kOuter, kFloor}, Part::deck, true, fitting.mesh);
  add_handrail(fitting, fitting.rings, {kOuter - 0.04, kFloor}, 2.0, false);
  for (const Ring& at : spaced_rings(fitting.shape, 2.0))
    add_bar(at.place(0.1, -kSpineDrop), at.place(kOuter - 0.05, kFloor - 0.09), 0.05, 0.04, 6, Part::tie, at.along,
            true, fitting.mesh);
}

// Adds floors on both sides, slightly below the cars' floor, with a yellow edge, a handrail at the back and legs to the
// ground.
void add_platforms(const Fitting& fitting) {
  constexpr double kInner = 1.02, kOuter = 3.4, kFloor = 0.22, kThick = 0.24, kEdge = 0.14;
  if (!walkable(fitting.rings, 0.35, 0.8)) return;
  const std::vector<Ring> rings = level(fitting.rings);
  for (const double side : {-1.0, 1.0}) {
    const auto strip = [&](double inner, double outer, double low, double high, Part part) {
      add_beam(rings, {std::min(side * inner, side * outer), low}, {std::max(side * inner, side * outer), high}, part,
               true, fitting.mesh);
    };
    strip(kInner, kOuter, kFloor - kThick, kFloor, Part::concrete);
    strip(kInner + 0.06, kInner + 0.06 + kEdge, kFloor, kFloor + 0.012, Part::stripe);
    add_handrail(fitting, rings, {side * (kOuter - 0.06), kFloor}, 1.8, true);
    for (const Ring& at : level(spaced_rings(fitting.shape, 4.5)))
      for (const double out : {kInner + 0.35, kOuter - 0.35}) {
        const dvec3 top = at.place(side * out, kFloor - 0.5 * kThick);
        if (top.y > kThick)
          add_bar({top.x, 0, top.z}, top, 0.14, 0.14, 8, Part::concrete, at.along, true, fitting.mesh);
      }
  }
}

}  // namespace

void add_fittings(const SegmentShape& shape, world::EquipmentKind kind, Mesh& mesh, const Detail& detail) {
  if (!detail.parts || !(shape.arc.length() > kShortestFitted)) return;
  const Fitting fitting{shape, rings_of(shape, detail.most_rings), mesh};
  switch (kind) {
    case world::EquipmentKind::station: return add_platforms(fitting);
    case world::EquipmentKind::lift: return add_chain(fitting), add_walkway(fitting);
    case world::EquipmentKind::launch: return add_stators(fitting);
    case world::EquipmentKind::brake:
    case world::EquipmentKind::block: return add_fins(fitting), add_walkway(fitting);
  }
}

}  // namespace coaster::sim
