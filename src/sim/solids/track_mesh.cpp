// The solids of the track, and of equipment on its segment's rails: chain, fins, motor blocks, walkway, platforms.
// Lengthwise parts run from joint to joint, so that a lift over several segments looks like one; rows of parts divide
// each segment evenly.
#include "sim/solids/track_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "base/portable_math.h"
#include "curve/frames.h"
#include "sim/ground/ground.h"
#include "sim/shape/rails.h"

namespace coaster::sim {
namespace {

using glm::dvec2;
using glm::dvec3;

constexpr double kShortestFitted = 0.5;  // m: on shorter segments nothing is shown

struct EquipmentMeshInput {
  const SegmentShape& shape;
  const CoasterForm& form;
  std::vector<Ring> rings;
  Mesh& mesh;
  const Ground* ground;

  // Returns rings whose up leads to the riders' side of the rails, for what acts on trains from the other side.
  std::vector<Ring> towards_riders(std::vector<Ring> some) const {
    if (form.side < 0)
      for (Ring& ring : some) ring.frame.up = -ring.frame.up;
    return some;
  }
  std::vector<Ring> rows(double spacing) const { return towards_riders(spaced_rings(shape, spacing)); }
};

// Adds a block around (left, up) with half sides along forward, up and left.
void add_block(const Ring& at, dvec2 middle, dvec3 half, Material part, bool from_afar, Mesh& mesh) {
  add_box(at.place(middle), at.frame, half, part, from_afar, mesh);
}

// The bed between the rails: crossbars from arm to arm and a beam along the track on them.
constexpr double kBedTop = -0.17, kBedSpacing = 1.5;
void add_bed(const EquipmentMeshInput& fitting, double half_width) {
  for (const Ring& at : fitting.rows(kBedSpacing))
    add_block(at, {0, kBedTop - 0.11}, {0.04, 0.04, 0.36}, Material::tie, false, fitting.mesh);
  add_beam(fitting.towards_riders(fitting.rings), {-half_width, kBedTop - 0.07}, {half_width, kBedTop}, Material::tie,
           true, fitting.mesh);
}

// Adds a band with a ridge for each second link, in a trough.
void add_chain(const EquipmentMeshInput& fitting) {
  constexpr double kPitch = 0.30, kTroughHalf = 0.15;
  add_bed(fitting, kTroughHalf);
  const std::vector<Ring> rings = fitting.towards_riders(fitting.rings);
  for (const double side : {-1.0, 1.0})
    add_beam(rings, {side * kTroughHalf, kBedTop}, {side * (kTroughHalf - 0.03), kBedTop + 0.06}, Material::tie, false,
             fitting.mesh);
  add_beam(rings, {-0.025, kBedTop}, {0.025, kBedTop + 0.055}, Material::chain, true, fitting.mesh);
  for (const Ring& at : fitting.rows(kPitch)) {
    for (const double side : {-1.0, 1.0})
      add_block(at, {0.062 * side, kBedTop + 0.05}, {0.105, 0.05, 0.018}, Material::chain, false, fitting.mesh);
    add_block(at, {0, kBedTop + 0.05}, {0.03, 0.028, 0.055}, Material::chain, false, fitting.mesh);
  }
}

// Adds two rows of upright plates between the rails.
void add_fins(const EquipmentMeshInput& fitting) {
  add_bed(fitting, 0.22);
  for (const Ring& at : fitting.rows(0.9)) {
    for (const double side : {-1.0, 1.0}) {
      add_block(at, {0.13 * side, kBedTop + 0.125}, {0.38, 0.125, 0.018}, Material::fin, true, fitting.mesh);
      add_block(at, {0.13 * side, kBedTop + 0.03}, {0.30, 0.03, 0.05}, Material::chain, false, fitting.mesh);
    }
  }
}

// Adds pairs of blocks, with a slot between them for the train's fin.
void add_stators(const EquipmentMeshInput& fitting) {
  add_bed(fitting, 0.30);
  for (const Ring& at : fitting.rows(0.75)) {
    for (const double side : {-1.0, 1.0}) {
      add_block(at, {0.16 * side, kBedTop + 0.10}, {0.31, 0.10, 0.09}, Material::stator, true, fitting.mesh);
      add_block(at, {0.16 * side, kBedTop + 0.215}, {0.25, 0.015, 0.06}, Material::chain, false, fitting.mesh);
    }
  }
}

bool walkable(const std::vector<Ring>& rings, double most_slope, double least_up) {
  return std::all_of(rings.begin(), rings.end(), [&](const Ring& ring) {
    return std::abs(ring.frame.forward.y) <= most_slope && ring.frame.up.y >= least_up;
  });
}

// Adds posts and two rails over the outer edge of a floor at (left, up).
void add_handrail(const EquipmentMeshInput& fitting, const std::vector<Ring>& rings, dvec2 edge, double spacing,
                  bool upright) {
  constexpr double kHeight = 1.05;
  for (const double height : {0.55, kHeight})
    add_beam(rings, edge + dvec2(-0.025, height - 0.025), edge + dvec2(0.025, height + 0.025), Material::support,
             height == kHeight, fitting.mesh);
  for (const Ring& at : upright ? level(spaced_rings(fitting.shape, spacing)) : spaced_rings(fitting.shape, spacing))
    add_block(at, edge + dvec2(0, 0.5 * kHeight), {0.025, 0.5 * kHeight, 0.025}, Material::support, false,
              fitting.mesh);
}

// Adds a walkway on brackets from the spine, on the left.
void add_walkway(const EquipmentMeshInput& fitting) {
  constexpr double kInner = 1.05, kOuter = 1.70;
  if (!fitting.form.walkway || !walkable(fitting.rings, 0.82, 0.75)) return;
  const double floor = *fitting.form.walkway;
  add_beam(fitting.rings, {kInner, floor - 0.05}, {kOuter, floor}, Material::deck, true, fitting.mesh);
  add_handrail(fitting, fitting.rings, {kOuter - 0.04, floor}, 2.0, false);
  for (const Ring& at : spaced_rings(fitting.shape, 2.0))
    add_bar(at.place(0.1, fitting.form.hold), at.place(kOuter - 0.05, floor - 0.09), 0.05, 0.04, 6, Material::tie, true,
            fitting.mesh);
}

// Adds floors on both sides, slightly below the cars' floor, with a yellow edge, a handrail at the back and legs to the
// ground.
void add_platforms(const EquipmentMeshInput& fitting) {
  constexpr double kInner = 1.02, kOuter = 3.4, kThick = 0.24, kEdge = 0.14;
  const double floor = fitting.form.platform;
  if (!walkable(fitting.rings, 0.35, 0.8)) return;
  const std::vector<Ring> rings = level(fitting.rings);
  // Under riders whose feet are free lies a floor.
  if (fitting.form.side < 0)
    add_beam(rings, {-kInner, floor - kThick}, {kInner, floor - 0.12}, Material::deck, true, fitting.mesh);
  for (const double side : {-1.0, 1.0}) {
    const auto strip = [&](double inner, double outer, double low, double high, Material part) {
      add_beam(rings, {side * inner, low}, {side * outer, high}, part, true, fitting.mesh);
    };
    strip(kInner, kOuter, floor - kThick, floor, Material::concrete);
    strip(kInner + 0.06, kInner + 0.06 + kEdge, floor, floor + 0.012, Material::stripe);
    add_handrail(fitting, rings, {side * (kOuter - 0.06), floor}, 1.8, true);
    for (const Ring& at : level(spaced_rings(fitting.shape, 4.5)))
      for (const double out : {kInner + 0.35, kOuter - 0.35}) {
        const dvec3 top = at.place(side * out, floor - 0.5 * kThick);
        const double foot = fitting.ground != nullptr ? fitting.ground->height(top.x, top.z) : 0;
        if (top.y - foot > kThick)
          add_bar({top.x, foot, top.z}, top, 0.14, 0.14, 8, Material::concrete, true, fitting.mesh);
      }
  }
}

constexpr double kRingTwist = base::radians(6.0);  // between rings
constexpr double kRingSpacing = 4.0;               // m, largest spacing on a segment that bends
constexpr double kStraight = base::radians(0.25);  // of bend and twist together: below it a segment is straight
constexpr double kShortestWithTie = 0.3;           // m

// Returns the frame of a knot, the same from both of its segments.
curve::Frame knot_frame(glm::vec3 tangent, glm::vec3 up) {
  const dvec3 forward = glm::normalize(dvec3(tangent));
  return {forward, curve::perpendicular(forward, dvec3(up))};
}

// Returns the ring of a knot: its rails are at the curve's `end`.
Ring knot_ring(const SegmentShape& shape, glm::vec3 end, const curve::Frame& frame, float along) {
  return {shape.key.rails == 0 ? dvec3(end) : dvec3(end) + shape.key.rails * frame.up, frame, along};
}

// Returns the number of rings that a stretch of `step` metres with a bend of `bend` radians needs: a chord over the
// angle b of a circle of radius r deviates by r b^2 / 8.
double rings_wanted(double bend, double twist, double step) {
  const double by_sagitta = std::sqrt(bend * step / (8 * kSagitta));
  return std::max({by_sagitta, twist / kRingTwist, step / kRingSpacing});
}

// Adds a plate from rail to spine, wider at the spine; its ends are inside both.
void add_arm(const Ring& at, double side, const ArmForm& arm, double half_tie, Mesh& mesh) {
  const dvec2 rail(0.5 * kGauge * side, 0), spine(arm.spine.x * side, arm.spine.y),
      along = glm::normalize(spine - rail);
  const dvec2 across = side * dvec2(-along.y, along.x);  // downwards and outwards, of a spine below
  const dvec3 thick = half_tie * at.frame.forward;
  const auto end = [&](dvec2 middle, double half) {
    const dvec3 low = at.place(middle + half * across), high = at.place(middle - half * across);
    return side < 0 ? std::array{low - thick, low + thick, high + thick, high - thick}
                    : std::array{low + thick, low - thick, high - thick, high + thick};
  };
  add_prism(end(rail, arm.half_at_rail), end(spine, arm.half_at_spine), Material::tie, true, mesh, at.along);
}

void add_lengths(std::span<const Ring> rings, const CoasterForm& form, Caps caps, Mesh& mesh) {
  for (Tube tube : form.tubes) {
    tube.caps = caps;
    add_tube(rings, tube, mesh);
  }
  for (const BeamForm& beam : form.beams) add_beam(rings, beam.low, beam.high, beam.part, beam.from_afar, mesh, caps);
}

void add_tie(const Ring& at, const CoasterForm& form, Mesh& mesh) {
  if (form.arms)
    for (const double side : {1.0, -1.0}) add_arm(at, side, *form.arms, form.half_tie, mesh);
  for (const PlateForm& plate : form.plates) {
    std::array<Ring, 2> ends{at, at};
    ends[0].position -= plate.half * at.frame.forward, ends[1].position += plate.half * at.frame.forward;
    add_extrusion(ends, plate.outline, plate.part, true, mesh);
  }
}

// Gives the vertices behind the origin to the first ring of a piece, `half` behind it, and the others to the second
// one.
void flatten(Mesh& mesh, double half) {
  constexpr float kRounding = 1e-6f;  // m
  for (MeshVertex& vertex : mesh.vertices) {
    const bool second = vertex.position.x > 0;
    vertex.along = second ? 1.0f : 0.0f;
    vertex.position.x -= static_cast<float>(second ? half : -half);
    if (std::abs(vertex.position.x) < kRounding) vertex.position.x = 0;
  }
}

}  // namespace

void add_fittings(const SegmentShape& shape, world::EquipmentKind kind, Mesh& mesh, const SolidsDetail& detail,
                  const Ground* ground) {
  if (!detail.parts || !(shape.arc.length() > kShortestFitted)) return;
  constexpr float kUnderRoof = 0.6f;
  const EquipmentMeshInput fitting{shape, form_of(shape), rings_of(shape, detail.most_rings), mesh, ground};
  const std::size_t first = mesh.vertices.size();
  switch (kind) {
    case world::EquipmentKind::station: add_platforms(fitting); break;
    case world::EquipmentKind::lift: add_chain(fitting), add_walkway(fitting); break;
    case world::EquipmentKind::launch: add_stators(fitting); break;
    case world::EquipmentKind::brake:
    case world::EquipmentKind::block: add_fins(fitting), add_walkway(fitting); break;
  }
  for (std::size_t i = first; i < mesh.vertices.size(); ++i)
    mesh.vertices[i].along = kind == world::EquipmentKind::station ? kUnderRoof : 0;
}

Ring ring_at(const SegmentShape& shape, double s) {
  const curve::Cubic& c = shape.key.cubic;
  if (s <= 0) return knot_ring(shape, c.p0, knot_frame(shape.key.tangent_from, shape.key.up_from), 0);
  if (s >= shape.arc.length()) return knot_ring(shape, c.p3, knot_frame(shape.key.tangent_to, shape.key.up_to), 1);
  return {rails_at(shape, s), frame_at(shape, s), static_cast<float>(s / shape.arc.length())};
}

std::vector<double> ring_places(const SegmentShape& shape, int most) {
  const double length = shape.arc.length();
  std::array<double, kFrameIntervals + 1> place{}, wanted{};
  double turned = 0;
  std::array<double, kFrameIntervals + 1> bends{}, twists{};
  glm::dvec3 last = shape.frame(0).forward;
  for (int i = 1; i <= kFrameIntervals; ++i) {
    const glm::dvec3 next = shape.frame(i).forward;
    place[i] = i == kFrameIntervals ? length : shape.arc.distance(static_cast<double>(i) / kFrameIntervals);
    bends[i] = curve::angle_between(last, next);
    last = next;
    twists[i] = std::abs(shape.roll.angle(place[i]) - shape.roll.angle(place[i - 1]));
    turned += bends[i] + twists[i];
  }
  const bool straight = turned < kStraight;
  for (int i = 1; i <= kFrameIntervals; ++i) {
    const double step = place[i] - place[i - 1], share = length > 0 ? step / length : 0.0;
    // Rails on the outer side of a bend are longer than the curve.
    const double longest = step + std::abs(shape.key.rails) * bends[i];
    wanted[i] = wanted[i - 1] + (straight ? share : rings_wanted(bends[i], twists[i], longest));
  }
  const int intervals = std::clamp(static_cast<int>(std::ceil(wanted.back() - 1e-6)), 1, most - 1);
  std::vector<double> rings{0.0};
  int below = 0;
  for (int i = 1; i < intervals; ++i) {
    const double at = wanted.back() * i / intervals;
    while (below + 1 < kFrameIntervals && wanted[below + 1] < at) ++below;
    const double span = wanted[below + 1] - wanted[below];
    rings.push_back(std::lerp(place[below], place[below + 1], span > 0 ? (at - wanted[below]) / span : 0.0));
  }
  rings.push_back(length);
  return rings;
}

std::vector<Ring> rings_of(const SegmentShape& shape, int most) {
  std::vector<Ring> rings;
  for (const double s : ring_places(shape, most)) rings.push_back(ring_at(shape, s));
  // A segment of zero length has the start ring twice.
  if (!(shape.arc.length() > 0))
    rings.back() = knot_ring(shape, shape.key.cubic.p3, knot_frame(shape.key.tangent_to, shape.key.up_to), 1);
  return rings;
}

std::vector<Ring> level(std::vector<Ring> rings) {
  for (Ring& ring : rings) ring.frame.up = curve::perpendicular(ring.frame.forward, {0, 1, 0});
  return rings;
}

dvec3 level_side(const curve::Frame& frame) {
  const dvec3 across(frame.forward.z, 0, -frame.forward.x), left(frame.left().x, 0, frame.left().z);
  if (glm::length(across) > 0.2) return glm::normalize(across);
  return glm::length(left) > 0.2 ? glm::normalize(left) : dvec3(1, 0, 0);
}

std::vector<Ring> spaced_rings(const SegmentShape& shape, double spacing) {
  const double length = shape.arc.length();
  const int count = std::max(1, static_cast<int>(std::lround(length / spacing)));
  std::vector<Ring> rings;
  for (int i = 0; i < count; ++i) rings.push_back(ring_at(shape, length * (i + 0.5) / count));
  return rings;
}

void sweep_track(const SegmentShape& shape, Mesh& mesh, Caps caps, const SolidsDetail& detail) {
  mesh.clear();
  if (detail.most_rings == 0) return;
  const std::vector<Ring> rings = rings_of(shape, detail.most_rings);
  add_lengths(rings, form_of(shape), caps, mesh);
  for (const Ring& at : tie_rings(shape, detail)) add_tie(at, form_of(shape), mesh);
}

std::vector<Ring> tie_rings(const SegmentShape& shape, const SolidsDetail& detail) {
  if (!detail.parts || !(shape.arc.length() > kShortestWithTie)) return {};
  return spaced_rings(shape, form_of(shape).tie_spacing);
}

TrackPieces track_pieces(const CoasterForm& form) {
  const curve::Frame frame{{1, 0, 0}, {0, 1, 0}};
  const std::array rings{Ring{{-1, 0, 0}, frame}, Ring{{1, 0, 0}, frame}};
  TrackPieces pieces;
  add_lengths(rings, form, {false, false}, pieces.tubes);
  add_lengths(rings, form, {false, true}, pieces.caps);
  // Without the sides, whose triangles join both rings.
  const std::vector<MeshVertex>& vertices = pieces.caps.vertices;
  std::vector<std::uint32_t> fans;
  for (std::size_t i = 0; i < pieces.caps.indices.size(); i += 3) {
    const std::uint32_t* const corner = &pieces.caps.indices[i];
    if (std::all_of(corner, corner + 3, [&](std::uint32_t at) { return vertices[at].position.x > 0; }))
      fans.insert(fans.end(), corner, corner + 3);
  }
  pieces.caps.indices = std::move(fans);
  add_tie({{0, 0, 0}, frame}, form, pieces.tie);
  flatten(pieces.tubes, 1), flatten(pieces.caps, 1), flatten(pieces.tie, form.half_tie);
  return pieces;
}

}  // namespace coaster::sim
