#include "view/spin_ring.h"

#include <algorithm>
#include <cmath>

#include "base/portable_math.h"
#include "curve/frames.h"
#include "view/gizmo.h"

namespace coaster::view {
namespace {

constexpr std::uint32_t kRingColour = 0xb58cf07a, kArcColour = 0xc9a6ffff;
constexpr double kStep = base::radians(7.5);
constexpr double kEdgeOn = 0.05;  // cosine between the ray and the tangent

double angle_of(double spin) {
  const double most = base::radians(kSpinMost_deg);
  return std::clamp(spin, -most, most) * kSpinAhead;
}

void add_arc(const SpinRing& ring, double from, double to, float width, std::uint32_t colour, Overlay& overlay) {
  const int steps = std::max(1, static_cast<int>(std::ceil(std::abs(to - from) / kStep)));
  for (int i = 0; i < steps; ++i)
    overlay.lines.push_back({glm::vec3(ring.at(from + (to - from) * i / steps)),
                             glm::vec3(ring.at(from + (to - from) * (i + 1) / steps)), width, colour});
}

}  // namespace

glm::dvec3 SpinRing::at(double angle) const { return centre + radius * curve::rotate(up, tangent, angle); }
glm::dvec3 SpinRing::handle() const { return at(angle_of(spin)); }

std::optional<SpinRing> spin_ring_of(const world::Document& document, const world::Settings& settings,
                                     const View& view) {
  const world::Knot* const knot = document.entities.find<world::Knot>(settings.selected);
  if (knot == nullptr || !settings.also.empty()) return std::nullopt;
  const auto gizmo = gizmo_of(document, settings, view);
  if (!gizmo) return std::nullopt;
  const glm::dvec3 tangent = glm::normalize(glm::dvec3(knot->tangent));
  return SpinRing{settings.selected,
                  glm::dvec3(knot->position),
                  tangent,
                  curve::perpendicular(tangent, glm::dvec3(knot->up)),
                  double{kSpinRadius * mark_scale(settings, view) / gizmo->metre_px},
                  double{knot->spin}};
}

std::optional<double> spin_under(const SpinRing& ring, const Ray& ray) {
  if (std::abs(glm::dot(glm::normalize(glm::dvec3(ray.direction)), ring.tangent)) < kEdgeOn) return std::nullopt;
  const auto hit = meet_plane(ray, glm::vec3(ring.centre), glm::vec3(ring.tangent));
  if (!hit) return std::nullopt;
  const glm::dvec3 to = glm::dvec3(*hit) - ring.centre;
  if (!(glm::length(to) > 1e-3 * ring.radius)) return std::nullopt;
  return curve::signed_angle(ring.up, to, ring.tangent) / kSpinAhead;
}

void add_spin_ring(const SpinRing& ring, float scale, Overlay& overlay) {
  add_arc(ring, 0, 2 * base::kPi, 1.5f * scale, kRingColour, overlay);
  add_arc(ring, 0, angle_of(ring.spin), 3.0f * scale, kArcColour, overlay);
}

}  // namespace coaster::view
