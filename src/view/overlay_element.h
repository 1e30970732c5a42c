// Where the palette's element would go: rails and ties in outline, a dashed line through its middle, its knots, plumb
// lines to the ground.
#pragma once

#include "sim/study/element_room.h"
#include "view/overlay.h"

namespace coaster::view {

// 0xRRGGBBAA: the element, what leads into it, and what of it is in the ground or lacks room (as conflicts).
inline constexpr std::uint32_t kElementColour = 0x66d9e8ff, kLeadColour = 0xffc078ff, kBuriedColour = 0xff6b6bff,
                               kNarrowColour = 0xffdd33ff;
inline constexpr int kMaxElementSteps = 900;  // of each rail, whatever the length

// Nothing for an element that cannot be placed. At most 9 lines a step.
void add_element(const sim::ElementPlan& plan, std::span<const sim::Narrow> narrow, const View& view, float scale,
                 Overlay& overlay);

}  // namespace coaster::view
