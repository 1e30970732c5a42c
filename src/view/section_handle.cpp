#include "view/section_handle.h"

#include <algorithm>
#include <cmath>

#include "base/portable_math.h"
#include "curve/frames.h"
#include "sim/shape/rails.h"
#include "view/overlay_detail.h"
#include "world/element_rows.h"
#include "world/sections.h"

namespace coaster::view {
namespace {

using glm::dvec3;

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
