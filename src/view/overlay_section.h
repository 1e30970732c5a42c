// The selected section: its curve in a wide line.
#pragma once

#include "view/overlay.h"

namespace coaster::view {

inline constexpr std::size_t kMaxSectionLines = 2000;  // whatever the number of segments, if that is less

// Adds nothing if no section is selected.
void add_selected_section(const world::Document& document, const sim::Derived& derived, world::Entity selected,
                          float scale, Overlay& overlay);

}  // namespace coaster::view
