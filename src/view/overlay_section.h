// The selected sections and the one under the mouse, marked by wide lines along their rails.
#pragma once

#include "view/overlay.h"

namespace coaster::view {

inline constexpr std::size_t kMaxSectionLines = 2000;  // for each, unless its number of segments is larger

// Adds the lines; nothing if no section is selected. The section under the mouse shows in the workspace Build, if it is
// planned.
void add_sections(const world::Document& document, const sim::Derived& derived, const world::Settings& settings,
                  const View& view, const Pick& hovered, Overlay& overlay);

}  // namespace coaster::view
