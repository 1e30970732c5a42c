// The force graph of Build: g, speed and height of the whole ride over distance, across the window.
#pragma once

#include "ui/context/ui.h"
#include "view/camera.h"

namespace coaster::ui {

// A bar with the values where the mouse points, else at the train, and below it the plot; the bar alone where the area
// is no higher.
void build_force_graph(Ui& ui, const view::Viewport& area);

}  // namespace coaster::ui
