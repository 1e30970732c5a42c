// The handle in the view of the selected section: dragging it changes the section's height, length or radius.
#pragma once

#include <optional>
#include <string_view>

#include "view/camera.h"
#include "view/overlay.h"

namespace coaster::view {

struct SectionHandle {
  world::Entity section;
  std::string_view parameter;  // "height", "length" or "radius"
  double value = 0;            // of it, now
  glm::dvec3 from{0}, at{0};   // m: where the section begins, and the handle, on the rails' curve
};

// Returns the handle of a planned section: its height at the place farthest above or below its start, else its length
// or its radius at its end. Nothing for others.
std::optional<SectionHandle> section_handle(const world::Document& document, const sim::Derived& derived,
                                            world::Entity section);
// True in the workspace Build with one section selected: its handles show.
bool section_handles_show(const world::Settings& settings);

// Returns the parameter for which the handle is where the ray meets its line (height, length) or the level plane
// (radius); nothing where they do not meet. The place of a handle is proportional to its value.
std::optional<double> value_under(const SectionHandle& handle, const Ray& ray);

void add_section_handle(const SectionHandle& handle, float scale, bool hovered, Overlay& overlay);

}  // namespace coaster::view
