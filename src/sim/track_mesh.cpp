// Sweeps one segment: rings where the curve bends, three tubes through them, arms from the rails down to the spine.
#include "sim/track_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/portable_math.h"

namespace coaster::sim {
namespace {

using glm::dvec2;
using glm::dvec3;

constexpr double kRingAngle = base::radians(6.0);    // of bend or twist from ring to ring
constexpr double kRingSpacing = 3.0;                 // m, the most on a segment that bends at all
constexpr double kStraight = base::radians(0.25);    // of bend and twist together: below it a segment counts as straight
constexpr double kArmHalf = 0.055;                   // m, half the side of a tie's arm
constexpr double kShortestWithTie = 0.3;             // m

struct Station {
  dvec3 position;
  curve::Frame frame;
  float along = 0;  // arc length over the segment's
};

double angle_between(dvec3 a, dvec3 b) { return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)); }

// Joint frames come from the knots alone, so both segments at a joint have the same.
Station station_at(const SegmentShape& shape, double s) {
  const curve::Cubic& c = shape.key.cubic;
  if (s <= 0) return {curve::point(c, 0.0), shape.frames.front(), 0};
  if (s >= shape.arc.length()) {
    const dvec3 forward = shape.frames.back().forward;
    return {curve::point(c, 1.0), {forward, curve::perpendicular(forward, dvec3(shape.key.up_to))}, 1};
  }
  return {curve::point(c, shape.arc.parameter(s)), frame_at(shape, s), static_cast<float>(s / shape.arc.length())};
}

// Distances of the rings from the segment's start: as many as bend, twist and length ask for, and closer where they ask for more.
std::vector<double> ring_places(const SegmentShape& shape) {
  const double length = shape.arc.length();
  std::array<double, kFrameIntervals + 1> place{}, wanted{};
  double turned = std::abs(shape.twist);
  for (int i = 0; i < kFrameIntervals; ++i) turned += angle_between(shape.frames[i].forward, shape.frames[i + 1].forward);
  const bool straight = turned < kStraight;
  for (int i = 1; i <= kFrameIntervals; ++i) {
    place[i] = i == kFrameIntervals ? length : shape.arc.distance(static_cast<double>(i) / kFrameIntervals);
    const double step = place[i] - place[i - 1], share = length > 0 ? step / length : 0.0;
    const double bend = angle_between(shape.frames[i - 1].forward, shape.frames[i].forward);
    const double angle = std::max(bend, std::abs(shape.twist) * share);
    wanted[i] = wanted[i - 1] + (straight ? share : std::max(angle / kRingAngle, step / kRingSpacing));
  }
  const int intervals = std::clamp(static_cast<int>(std::ceil(wanted.back() - 1e-6)), 1, kMaxRings - 1);
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

// Unit circle, counter-clockwise as seen by one who looks against the direction of travel: x to the left, y up.
std::array<dvec2, kTubeSides> circle() {
  std::array<dvec2, kTubeSides> out;
  for (int k = 0; k < kTubeSides; ++k) {
    const base::SinCos turn = base::sin_cos(2.0 * base::kPi * (k + 0.5) / kTubeSides);
    out[k] = {turn.cos, turn.sin};
  }
  return out;
}

// The sides of a tube between rings of `sides` vertices, and a fan over each end.
void add_tube_indices(std::uint32_t first, std::uint32_t sides, std::uint32_t rings, Mesh& mesh) {
  for (std::uint32_t ring = 0; ring + 1 < rings; ++ring)
    for (std::uint32_t k = 0; k < sides; ++k) {
      const std::uint32_t a = first + ring * sides + k, b = first + ring * sides + (k + 1) % sides;
      mesh.indices.insert(mesh.indices.end(), {a, b, a + sides, b, b + sides, a + sides});
    }
  const std::uint32_t last = first + (rings - 1) * sides;
  for (std::uint32_t k = 1; k + 1 < sides; ++k) mesh.indices.insert(mesh.indices.end(), {first, first + k + 1, first + k, last, last + k, last + k + 1});
}

// A tube about the line that runs at `offset` (left, up) from the rails' middle.
void add_tube(std::span<const Station> stations, dvec2 offset, double radius, Part part, Mesh& mesh) {
  const auto unit = circle();
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  for (const Station& at : stations) {
    const dvec3 left = at.frame.left(), up = at.frame.up, centre = at.position + offset.x * left + offset.y * up;
    for (const dvec2 u : unit) {
      const dvec3 normal = u.x * left + u.y * up;
      mesh.vertices.push_back({glm::vec3(centre + radius * normal), glm::vec3(normal), static_cast<float>(part), at.along});
    }
  }
  add_tube_indices(first, kTubeSides, static_cast<std::uint32_t>(stations.size()), mesh);
}

// A square bar from rail to spine; its ends are inside both.
void add_arm(const Station& at, double side, Mesh& mesh) {
  const dvec3 left = at.frame.left();
  const dvec3 rail = at.position + 0.5 * kGauge * side * left, spine = at.position - kSpineDrop * at.frame.up;
  const dvec3 along = glm::normalize(spine - rail), across = glm::cross(along, at.frame.forward);
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  for (const dvec3 end : {rail, spine})
    for (const dvec2 corner : {dvec2(-1, -1), dvec2(1, -1), dvec2(1, 1), dvec2(-1, 1)}) {
      const dvec3 out = corner.x * at.frame.forward + corner.y * across;
      mesh.vertices.push_back({glm::vec3(end + kArmHalf * out), glm::vec3(glm::normalize(out)), static_cast<float>(Part::tie), at.along});
    }
  add_tube_indices(first, 4, 2, mesh);
}

}  // namespace

void sweep_track(const SegmentShape& shape, Mesh& mesh) {
  mesh.vertices.clear();
  mesh.indices.clear();
  std::vector<Station> stations;
  for (const double s : ring_places(shape)) stations.push_back(station_at(shape, s));
  add_tube(stations, {0.5 * kGauge, 0}, kRailRadius, Part::rail, mesh);
  add_tube(stations, {-0.5 * kGauge, 0}, kRailRadius, Part::rail, mesh);
  add_tube(stations, {0, -kSpineDrop}, kSpineRadius, Part::spine, mesh);
  const double length = shape.arc.length();
  if (!(length > kShortestWithTie)) return;
  const int ties = std::max(1, static_cast<int>(std::lround(length / kTieSpacing)));
  for (int i = 0; i < ties; ++i) {
    const Station at = station_at(shape, length * (i + 0.5) / ties);
    add_arm(at, 1.0, mesh);
    add_arm(at, -1.0, mesh);
  }
}

}  // namespace coaster::sim
