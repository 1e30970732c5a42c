// The first steps, in the viewport's lower left corner while Settings::show_hints.
#pragma once

#include "ui/context/ui.h"

namespace coaster::ui {

void draw_hints(Ui& ui, const view::Viewport& scene);

}  // namespace coaster::ui
