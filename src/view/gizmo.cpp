#include "view/gizmo.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/portable_math.h"
#include "curve/frames.h"
#include "view/marks.h"
#include "view/overlay_detail.h"
#include "world/aid_settings.h"
#include "world/panel_settings.h"
#include "world/selection.h"

namespace coaster::view {
namespace {

using glm::dvec2;

constexpr std::array<std::uint32_t, 3> kColours{0xe5534bff, 0x4fb477ff, 0x4c9affff};
constexpr std::uint32_t kHovered = 0xffe08aff, kRim = 0x10141aaa;
constexpr float kWidth = 3, kHeadHalf = 5, kFewest = 14;  // px; arrows shorter than kFewest on screen cannot be picked

glm::vec3 axis(int i) {
  glm::vec3 v(0);
  v[i] = 1;
  return v;
}
glm::vec3 along(const Gizmo& gizmo, float scale, int i, float px) {
  return gizmo.at + axis(i) * (px * scale / gizmo.metre_px);
}
glm::vec3 corner(const Gizmo& gizmo, float scale, int normal, float a, float b) {
  const int u = (normal + 1) % 3, v = (normal + 2) % 3;
  return gizmo.at + (axis(u) * a + axis(v) * b) * (scale / gizmo.metre_px);
}
std::array<glm::vec3, 4> square(const Gizmo& gizmo, float scale, int normal) {
  constexpr float n = kGizmoPlaneNear, f = kGizmoPlaneFar;
  return {corner(gizmo, scale, normal, n, n), corner(gizmo, scale, normal, f, n), corner(gizmo, scale, normal, f, f),
          corner(gizmo, scale, normal, n, f)};
}

double distance_to_segment(dvec2 p, dvec2 a, dvec2 b) {
  const dvec2 way = b - a;
  const double square = glm::dot(way, way), t = square > 0 ? std::clamp(glm::dot(p - a, way) / square, 0.0, 1.0) : 0.0;
  return glm::length(p - a - t * way);
}

bool inside(const std::array<dvec2, 4>& corners, dvec2 p) {
  int turn = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    const dvec2 side = corners[(i + 1) % 4] - corners[i], to = p - corners[i];
    turn += side.x * to.y - side.y * to.x > 0 ? 1 : -1;
  }
  return std::abs(turn) == 4;
}
double area(const std::array<dvec2, 4>& c) {
  const dvec2 a = c[2] - c[0], b = c[3] - c[1];
  return std::abs(a.x * b.y - a.y * b.x) / 2;
}

PickKind axis_kind(int i) { return static_cast<PickKind>(static_cast<int>(PickKind::axis_x) + i); }
PickKind plane_kind(int i) { return static_cast<PickKind>(static_cast<int>(PickKind::plane_x) + i); }

constexpr std::uint32_t kRingColour = 0xb58cf07a, kArcColour = 0xc9a6ffff;
constexpr double kStep = base::radians(7.5);

double angle_of(double spin) {
  const double most = base::radians(kSpinMost_deg);
  return std::clamp(spin, -most, most) * kSpinAhead;
}

}  // namespace

std::optional<Gizmo> gizmo_of(const world::Document& document, const world::Settings& settings, const View& view) {
  if (!settings.aids->show_gizmo || !settings.panels->show_panels || settings.aids->append_mode)
    return std::nullopt;  // clicks append knots there
  const std::vector<world::Entity> knots = world::selected_knots(document, settings);
  if (knots.empty()) return std::nullopt;
  glm::dvec3 sum(0);
  for (const world::Entity e : knots) sum += glm::dvec3(world::knot(document, e).position);
  const glm::vec3 at(sum / static_cast<double>(knots.size()));
  const double metre = PixelScale(view)(glm::dvec3(at));
  if (!(metre > 1e-6) || !Projector(view)(glm::dvec3(at))) return std::nullopt;
  return Gizmo{at, static_cast<float>(metre)};
}

PickKind pick_gizmo(const Gizmo& gizmo, const View& view, float scale, glm::vec2 pixel) {
  const Projector projector(view);
  PickKind best = PickKind::none;
  double least = static_cast<double>(kGizmoReach * view.reach) * scale;
  for (int i = 0; i < 3; ++i) {
    const auto from = projector(glm::dvec3(along(gizmo, scale, i, kGizmoGap))),
               to = projector(glm::dvec3(along(gizmo, scale, i, kGizmoLength)));
    if (!from || !to || glm::length(*to - *from) < kFewest * scale) continue;
    const double distance = distance_to_segment(dvec2(pixel), *from, *to);
    if (distance < least) least = distance, best = axis_kind(i);
  }
  if (best != PickKind::none) return best;
  double nearest = 0;  // among overlapping squares
  for (int i = 0; i < 3; ++i) {
    std::array<dvec2, 4> corners;
    bool seen = true;
    const auto world = square(gizmo, scale, i);
    for (std::size_t k = 0; k < 4; ++k) {
      const auto at = projector(glm::dvec3(world[k]));
      seen = seen && at;
      if (at) corners[k] = *at;
    }
    if (!seen || area(corners) <= kFewest * scale * scale || !inside(corners, dvec2(pixel))) continue;
    const glm::dvec3 away = glm::dvec3(world[0]) + glm::dvec3(world[2]) - 2.0 * glm::dvec3(view.eye);
    const double distance = view.parallel > 0 ? glm::dot(away, glm::dvec3(line_of_sight(view))) : glm::length(away);
    if (best == PickKind::none || distance < nearest) nearest = distance, best = plane_kind(i);
  }
  return best;
}

glm::vec3 gizmo_place(const Gizmo& gizmo, float scale, PickKind kind) {
  constexpr float kOnArrow = 0.82f * kGizmoLength, kOnSquare = (kGizmoPlaneNear + kGizmoPlaneFar) / 2;
  return is_axis(kind) ? along(gizmo, scale, gizmo_axis(kind), kOnArrow)
                       : corner(gizmo, scale, gizmo_axis(kind), kOnSquare, kOnSquare);
}

void add_gizmo(const Gizmo& gizmo, const View& view, float scale, PickKind hovered, Overlay& overlay) {
  const Projector projector(view);
  for (int i = 0; i < 3; ++i) {
    const std::uint32_t colour =
        hovered == plane_kind(i) ? kHovered : faded(kColours[static_cast<std::size_t>(i)], 0xb0);
    const auto corners = square(gizmo, scale, i);
    for (std::size_t k = 0; k < 4; ++k)
      overlay.lines.push_back(
          {corners[k], corners[(k + 1) % 4], (hovered == plane_kind(i) ? 3.0f : 2.0f) * scale, colour});
  }
  for (int i = 0; i < 3; ++i) {
    const glm::vec3 from = along(gizmo, scale, i, kGizmoGap), to = along(gizmo, scale, i, kGizmoLength);
    const auto a = projector(glm::dvec3(from)), b = projector(glm::dvec3(to));
    if (!a || !b || glm::length(*b - *a) < kFewest * scale) continue;
    const bool chosen = hovered == axis_kind(i);
    const std::uint32_t colour = chosen ? kHovered : kColours[static_cast<std::size_t>(i)];
    overlay.lines.push_back({from, to, (kWidth + 2) * scale, kRim});
    overlay.lines.push_back({from, to, (chosen ? kWidth + 1 : kWidth) * scale, colour});
    overlay.marks.push_back({to, (kHeadHalf + 1) * scale, kRim, MarkShape::square});
    overlay.marks.push_back({to, (chosen ? kHeadHalf + 1 : kHeadHalf) * scale, colour, MarkShape::square});
  }
}

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
  const auto angle = angle_on_ring(ray, ring.centre, ring.tangent, ring.up, ring.radius);
  return angle ? std::optional(*angle / kSpinAhead) : std::nullopt;
}

void add_spin_ring(const SpinRing& ring, float scale, Overlay& overlay) {
  const auto at = [&](double angle) { return ring.at(angle); };
  add_arc(at, 0, 2 * base::kPi, kStep, 1.5f * scale, kRingColour, overlay);
  add_arc(at, 0, angle_of(ring.spin), kStep, 3.0f * scale, kArcColour, overlay);
}

}  // namespace coaster::view
