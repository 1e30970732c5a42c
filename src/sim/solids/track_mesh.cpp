// Sweeps one segment: rings where the curve bends, three tubes through them, and arms from the rails down to the spine.
#include "sim/solids/track_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "base/portable_math.h"
#include "curve/frames.h"
#include "sim/shape/rails.h"

namespace coaster::sim {
namespace {

using glm::dvec2;
using glm::dvec3;

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
void add_arm(const Ring& at, double side, Mesh& mesh) {
  constexpr double kHalfAtRail = 0.06, kHalfAtSpine = 0.15;
  const dvec2 rail(0.5 * kGauge * side, 0), spine(0.06 * side, -kSpineDrop + 0.04),
      along = glm::normalize(spine - rail);
  const dvec2 across = side * dvec2(-along.y, along.x);  // downwards and outwards
  const dvec3 thick = kHalfTie * at.frame.forward;
  const auto end = [&](dvec2 middle, double half) {
    const dvec3 low = at.place(middle + half * across), high = at.place(middle - half * across);
    return side < 0 ? std::array{low - thick, low + thick, high + thick, high - thick}
                    : std::array{low + thick, low - thick, high - thick, high + thick};
  };
  add_prism(end(rail, kHalfAtRail), end(spine, kHalfAtSpine), Part::tie, at.along, true, mesh);
}

void add_tubes(std::span<const Ring> rings, Caps caps, Mesh& mesh) {
  add_tube(rings, {{0.5 * kGauge, 0}, kRailRadius, kRailSides, kRailSides / 2, Part::rail, caps}, mesh);
  add_tube(rings, {{-0.5 * kGauge, 0}, kRailRadius, kRailSides, kRailSides / 2, Part::rail, caps}, mesh);
  add_tube(rings, {{0, -kSpineDrop}, kSpineRadius, kSpineSides, kSpineSides / 3, Part::spine, caps}, mesh);
}

void add_tie(const Ring& at, Mesh& mesh) { add_arm(at, 1.0, mesh), add_arm(at, -1.0, mesh); }

// Moves the vertices behind the origin to the first ring of a piece and the others to the second one.
void flatten(Mesh& mesh) {
  for (MeshVertex& vertex : mesh.vertices) {
    vertex.along = vertex.position.x > 0 ? 1.0f : 0.0f;
    vertex.position.x = 0;
  }
}

}  // namespace

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

std::vector<Ring> spaced_rings(const SegmentShape& shape, double spacing) {
  const double length = shape.arc.length();
  const int count = std::max(1, static_cast<int>(std::lround(length / spacing)));
  std::vector<Ring> rings;
  for (int i = 0; i < count; ++i) rings.push_back(ring_at(shape, length * (i + 0.5) / count));
  return rings;
}

void sweep_track(const SegmentShape& shape, Mesh& mesh, Caps caps, const Detail& detail) {
  mesh.clear();
  if (detail.most_rings == 0) return;
  const std::vector<Ring> rings = rings_of(shape, detail.most_rings);
  add_tubes(rings, caps, mesh);
  for (const Ring& at : tie_rings(shape, detail)) add_tie(at, mesh);
}

std::vector<Ring> tie_rings(const SegmentShape& shape, const Detail& detail) {
  if (!detail.parts || !(shape.arc.length() > kShortestWithTie)) return {};
  return spaced_rings(shape, kTieSpacing);
}

TrackPieces track_pieces() {
  const curve::Frame frame{{1, 0, 0}, {0, 1, 0}};
  const std::array rings{Ring{{-1, 0, 0}, frame}, Ring{{1, 0, 0}, frame}};
  TrackPieces pieces;
  add_tubes(rings, {false, false}, pieces.tubes);
  add_tubes(rings, {false, true}, pieces.caps);
  // Without the sides, whose triangles join both rings.
  const std::vector<MeshVertex>& vertices = pieces.caps.vertices;
  std::vector<std::uint32_t> fans;
  for (std::size_t i = 0; i < pieces.caps.indices.size(); i += 3) {
    const std::uint32_t* const corner = &pieces.caps.indices[i];
    if (std::all_of(corner, corner + 3, [&](std::uint32_t at) { return vertices[at].position.x > 0; }))
      fans.insert(fans.end(), corner, corner + 3);
  }
  pieces.caps.indices = std::move(fans);
  add_tie({{0, 0, 0}, frame}, pieces.tie);
  for (Mesh* mesh : {&pieces.tubes, &pieces.caps, &pieces.tie}) flatten(*mesh);
  return pieces;
}

}  // namespace coaster::sim
