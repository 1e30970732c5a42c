// The preview of the palette's element: rails and ties in outline, a dashed centre line, its knots, plumb lines to the
// ground.
#pragma once

#include "view/overlay.h"

namespace coaster::view {

// 0xRRGGBBAA: the element, its lead-in, and its parts below the ground or without clearance (as conflicts).
inline constexpr std::uint32_t kElementColour = 0x66d9e8ff, kLeadColour = 0xffc078ff, kBuriedColour = 0xff6b6bff,
                               kNarrowColour = 0xffdd33ff;
inline constexpr int kMaxElementSteps = 900;  // per rail, for any length

// Adds the preview; nothing for an element that cannot be placed. `rails`: as world::rails_height(). At most 9 lines
// per step.
void add_element(const sim::ElementPlan& plan, std::span<const sim::Narrow> narrow, double rails, const View& view,
                 float scale, Overlay& overlay);

}  // namespace coaster::view
