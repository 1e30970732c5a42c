// The legend of the track's colours, in a corner of the viewport while the track is coloured.
#pragma once

#include "ui/context/ui.h"

namespace coaster::ui {

// Drawn behind all windows. Hidden if the viewport is too small.
void draw_legend(Ui& ui, const view::Viewport& scene);

}  // namespace coaster::ui
