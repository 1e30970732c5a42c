// The hint at the bottom of the viewport: the current transform, or what to click next.
#pragma once

#include "ui/context/ui.h"
#include "ui/tools/viewport_tool.h"

namespace coaster::ui {

// Drawn behind all windows; nothing while there is nothing to say.
void draw_foot_line(const Ui& ui, const ViewportTool& tool, const view::Viewport& scene);

}  // namespace coaster::ui
