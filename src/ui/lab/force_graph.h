// The force graph of Build: g, speed and height of the whole ride over distance, across the window.
#pragma once

#include "ui/context/ui.h"
#include "view/camera.h"

namespace coaster::ui {

// A bar with tabs for the graph and the table of sections, and the values where the mouse points, else at the train.
// Below it the plot, unless the table is chosen; the bar alone where the area is no higher.
void build_force_graph(Ui& ui, const view::Viewport& area);

}  // namespace coaster::ui
