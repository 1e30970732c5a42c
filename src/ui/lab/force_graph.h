// The force graph of Build: g, speed and height of the whole ride over distance, across the window.
#pragma once

#include "ui/context/ui.h"
#include "view/camera.h"

namespace coaster::ui {

// Builds a bar with tabs for the graph and the table of sections, and the values at the mouse or else at the train.
// Below it is the plot, unless the table is selected; only the bar if the area is no higher.
void build_force_graph(Ui& ui, const view::Viewport& area);

}  // namespace coaster::ui
