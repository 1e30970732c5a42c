// The handle of the selected section in the view: dragging it changes the section's height, length or radius.
#pragma once

#include <optional>
#include <string_view>

#include "view/camera.h"
#include "view/overlay.h"

namespace coaster::view {

struct SectionHandle {
  world::Entity section;
  std::string_view parameter;  // "height", "length" or "radius"
  double value = 0;            // present value of the parameter
  glm::dvec3 from{0}, at{0};   // m: where the section begins, and the handle, on the rails' curve
};

// Returns the handle of a planned section: its height at the point farthest above or below its start, else its length
// or its radius at its end. Nothing for other sections.
std::optional<SectionHandle> section_handle(const world::Document& document, const sim::Derived& derived,
                                            world::Entity section);
// True if handles show: in the workspace Build with one section selected.
bool section_handles_show(const world::Settings& settings);

// Returns the value of the parameter that puts the handle where the ray meets its line (height, length) or the level
// plane (radius); nothing if they do not meet. The position of a handle is proportional to its value.
std::optional<double> value_under(const SectionHandle& handle, const Ray& ray);

void add_section_handle(const SectionHandle& handle, float scale, bool hovered, Overlay& overlay);

}  // namespace coaster::view
