// The laboratory's strip below the scene.
#pragma once

#include "ui/context/ui.h"

namespace coaster::ui {

// Builds a bar with the names of the pages and, while the strip is open, the selected page below it. To add a page, add
// a row in world/laboratory.h and a file with its function.
void build_laboratory(Ui& ui, const view::Viewport& area);

}  // namespace coaster::ui
