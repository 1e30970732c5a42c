// How far the mouse moves before a press becomes a drag.
#pragma once

namespace coaster::platform {

inline constexpr float kDragThreshold = 3;  // points; less is a click

}  // namespace coaster::platform
