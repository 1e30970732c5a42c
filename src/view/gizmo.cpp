#include "view/gizmo.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/portable_math.h"
#include "curve/frames.h"
#include "sim/shape/rails.h"
#include "view/marks.h"
#include "view/overlay_detail.h"
#include "world/aid_settings.h"
#include "world/element_rows.h"
#include "world/panel_settings.h"
#include "world/sections.h"
#include "world/selection.h"

namespace coaster::view {
namespace {

using glm::dvec2;
using glm::dvec3;

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

// --- Handles of sections

// Returns the position of the section that is farthest above or below its start: a joint of its segments, or one of 16
// positions on each.
dvec3 farthest_in_height(const sim::DerivedTrack& derived, const world::SectionRun& run, double from) {
  constexpr int kPlaces = 16;
  dvec3 farthest(0, from, 0);
  for (std::size_t i = run.first; i < run.end(); ++i)
    for (int k = 1; k <= kPlaces; ++k) {
      const dvec3 at = curve::point(derived.shape_at(i).key.cubic, static_cast<double>(k) / kPlaces);
      if (std::abs(at.y - from) >= std::abs(farthest.y - from)) farthest = at;
    }
  return farthest;
}

constexpr dvec3 kUp{0, 1, 0};
constexpr double kTurnShare = 0.6;  // radius of a turn's ring relative to that of the turn: clear of the rails
constexpr double kBankShare = 0.08, kLeastBank = 3,
                 kMostBank = 9;  // radius of a bank's ring relative to the length; m, m

AngleHandle turn_handle(const world::Element& element, const sim::DerivedTrack& derived, const world::SectionRun& run,
                        std::string_view parameter) {
  const curve::Cubic& first = derived.shape_at(run.first).key.cubic;
  const double side = element.right ? -1.0 : 1.0, radius = world::value_of(element, "radius");
  const dvec3 forward = curve::unit_tangent(first, 0.0);
  const dvec3 inside = side * glm::normalize(glm::cross(kUp, forward));
  const double whole = parameter == "turns" ? 1.0 / 360 : 1.0;
  return {PickKind::turn, {},
          parameter,      world::value_of(element, parameter) / whole,
          whole,          dvec3(first.p0) + radius * inside,
          side * kUp,     -kTurnShare * radius * inside};
}

// Returns the bank's handle: for an S-bend where its first turn is steepest, for others in the middle.
AngleHandle bank_handle(const world::Element& element, const sim::DerivedTrack& derived, const world::SectionRun& run) {
  const double from = derived.starts[run.first], length = derived.starts[run.end()] - from;
  const double share = element.kind == world::ElementKind::s_bend ? 0.25 : 0.5;
  const sim::TrackPlace place = sim::place_at(derived, from + share * length);
  const sim::SegmentShape& shape = derived.shape_at(place.index);
  const double t = shape.arc.parameter(place.s);
  const dvec3 forward = curve::unit_tangent(shape.key.cubic, t);
  return {PickKind::bank,
          {},
          "bank",
          world::value_of(element, "bank"),
          1,
          sim::rails_point(shape, t),
          element.right ? forward : -forward,
          std::clamp(kBankShare * length, kLeastBank, kMostBank) * curve::perpendicular(forward, kUp)};
}

}  // namespace

std::optional<Gizmo> gizmo_of(const world::Document& document, const world::Settings& settings, const View& view) {
  if (!settings.aids->show_gizmo || !settings.panels->show_panels || settings.aids->append_mode)
    return std::nullopt;  // clicks append knots there
  const std::vector<world::Entity> knots = world::selected_knots(document, settings);
  if (knots.empty()) return std::nullopt;
  const glm::vec3 at = world::middle_of(document, knots);
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

std::optional<SectionHandle> section_handle(const world::Document& document, const sim::DerivedTrack& derived,
                                            world::Entity section) {
  const world::Section* const value = document.entities.find<world::Section>(section);
  if (!value || value->kind != world::SectionKind::element) return std::nullopt;
  const world::SectionRun run = world::run_of(document, section);
  const dvec3 from(derived.shape_at(run.first).key.cubic.p0), end(derived.shape_at(run.end() - 1).key.cubic.p3);
  for (const std::string_view parameter : {"height", "length", "radius"}) {
    const auto found = world::found_value(value->element, parameter);
    if (!found) continue;
    const dvec3 at = parameter == "height" ? farthest_in_height(derived, run, from.y) : end;
    const double reach = parameter == "height" ? std::abs(at.y - from.y) : glm::distance(at, from);
    if (reach < 0.1) return std::nullopt;
    return SectionHandle{section, parameter, *found, from, at};
  }
  return std::nullopt;
}

bool section_handles_show(const world::Settings& settings) {
  return selects_sections(settings) && settings.also.empty();
}

std::optional<double> value_under(const SectionHandle& handle, const Ray& ray) {
  const glm::vec3 at(handle.at);
  if (handle.parameter == "height") {
    const auto height = meet_vertical(ray, at);
    if (!height) return std::nullopt;
    return handle.value * (*height - handle.from.y) / (handle.at.y - handle.from.y);
  }
  const auto place = meet_plane(ray, at, {0, 1, 0});
  if (!place) return std::nullopt;
  // Along the line from the start to the handle, in plan.
  const dvec3 way(handle.at.x - handle.from.x, 0, handle.at.z - handle.from.z);
  const double square = glm::dot(way, way);
  if (!(square > 1e-6)) return std::nullopt;
  return handle.value * glm::dot(dvec3(*place) - handle.from, way) / square;
}

void add_section_handle(const SectionHandle& handle, float scale, bool hovered, Overlay& overlay) {
  constexpr std::uint32_t kColour = 0xff8a1fff, kBright = 0xffc08aff, kThread = 0xff8a1f80;
  constexpr float kWidth = 1.5f;
  const glm::vec3 at(handle.at), from(handle.from);
  const glm::vec3 foot = handle.parameter == "height" ? glm::vec3(at.x, from.y, at.z) : from;
  overlay.lines.push_back({foot, at, kWidth * scale, kThread});
  overlay.marks.push_back(
      {at, kSectionHandleHalf * scale * (hovered ? 1.35f : 1.0f), hovered ? kBright : kColour, MarkShape::square});
}

dvec3 AngleHandle::at(double deg) const { return centre + curve::rotate(zero, axis, base::radians(deg)); }

std::vector<AngleHandle> angle_handles(const world::Document& document, const sim::DerivedTrack& derived,
                                       world::Entity section) {
  std::vector<AngleHandle> handles;
  const world::Section* const value = document.entities.find<world::Section>(section);
  if (!value || value->kind != world::SectionKind::element) return handles;
  const world::Element& element = value->element;
  const world::SectionRun run = world::run_of(document, section);
  const bool turns = world::found_value(element, "turns").has_value();
  const bool bends = element.kind == world::ElementKind::curve || element.kind == world::ElementKind::overbanked_turn;
  if (turns || bends) handles.push_back(turn_handle(element, derived, run, turns ? "turns" : "angle"));
  if (world::found_value(element, "bank") && world::found_value(element, "speed") == 0.0)
    handles.push_back(bank_handle(element, derived, run));
  for (AngleHandle& handle : handles) handle.section = section;
  return handles;
}

std::optional<AngleHandle> angle_handle(const world::Document& document, const sim::DerivedTrack& derived,
                                        world::Entity section, PickKind kind) {
  for (const AngleHandle& handle : angle_handles(document, derived, section))
    if (handle.kind == kind) return handle;
  return std::nullopt;
}

std::optional<double> angle_under(const AngleHandle& handle, const Ray& ray, double near) {
  const auto met = angle_on_ring(ray, handle.centre, handle.axis, handle.zero, glm::length(handle.zero));
  if (!met) return std::nullopt;
  const double angle = base::degrees(*met);
  return angle + 360 * std::round((near - angle) / 360);
}

void add_angle_handle(const AngleHandle& handle, float scale, bool hovered, Overlay& overlay) {
  constexpr std::uint32_t kRing = 0xff8a1f60, kArc = 0xff8a1fff, kBright = 0xffc08aff;
  const dvec3 at = handle.at(handle.angle);
  constexpr double kStep = 7.5;  // deg
  const auto point = [&](double deg) { return handle.at(deg); };
  add_arc(point, 0, 360, kStep, 1.5f * scale, kRing, overlay);
  add_arc(point, 0, std::fmod(handle.angle, 360.0), kStep, 3 * scale, kArc, overlay);
  overlay.lines.push_back({glm::vec3(handle.centre), glm::vec3(at), 1.5f * scale, kRing});
  overlay.marks.push_back({glm::vec3(at), kSectionHandleHalf * scale * (hovered ? 1.35f : 1.0f),
                           hovered ? kBright : kArc, MarkShape::disc});
}

}  // namespace coaster::view
