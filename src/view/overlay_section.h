// The selected sections and the one under the mouse: their rails in wide lines.
#pragma once

#include "view/overlay.h"

namespace coaster::view {

inline constexpr std::size_t kMaxSectionLines = 2000;  // of each, whatever the number of segments, if that is less

// Adds nothing if no section is selected. The section under the mouse shows in the workspace Build, if it is planned.
void add_sections(const world::Document& document, const sim::Derived& derived, const world::Settings& settings,
                  const Pick& hovered, Overlay& overlay);

}  // namespace coaster::view
