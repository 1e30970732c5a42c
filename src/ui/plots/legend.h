// The legend of the track's colours: a bar with numbers in a corner of the viewport, while the track is coloured by
// something.
#pragma once

#include "ui/widgets/widgets.h"

namespace coaster::ui {

// Drawn behind all windows; nothing where the viewport is too small for it.
void draw_legend(Ui& ui, const view::Viewport& scene);

}  // namespace coaster::ui
