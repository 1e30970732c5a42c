#include "view/section_handle.h"

#include <algorithm>
#include <cmath>

#include "view/workspace.h"
#include "world/sections.h"

namespace coaster::view {
namespace {

using glm::dvec3;

// Returns the position of the section that is farthest above or below its start: a joint of its segments, or one of 16
// positions on each.
dvec3 farthest_in_height(const sim::Derived& derived, const world::SectionRun& run, double from) {
  constexpr int kPlaces = 16;
  dvec3 farthest(0, from, 0);
  for (std::size_t i = run.first; i < run.end(); ++i)
    for (int k = 1; k <= kPlaces; ++k) {
      const dvec3 at = curve::point(derived.shape_at(i).key.cubic, static_cast<double>(k) / kPlaces);
      if (std::abs(at.y - from) >= std::abs(farthest.y - from)) farthest = at;
    }
  return farthest;
}

}  // namespace

std::optional<SectionHandle> section_handle(const world::Document& document, const sim::Derived& derived,
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

}  // namespace coaster::view
