// The strips at the foot of the window: the laboratory, and the force graph of Build.
#pragma once

#include "ui/context/ui.h"
#include "view/camera.h"

namespace coaster::ui {

// Builds a bar with the names of the pages and, while the strip is open, the selected page below it. To add a page, add
// a row in world/laboratory.h and a file with its function.
void build_laboratory(Ui& ui, const view::Viewport& area);

// Builds a bar with tabs for the graph and the table of sections, and the values at the mouse or else at the train.
// Below it is the plot, unless the table is selected; only the bar if the area is no higher.
void build_force_graph(Ui& ui, const view::Viewport& area);

}  // namespace coaster::ui
