// The score card at the end of a ride: results, the challenge's verdict, and why the ride failed.
#pragma once

#include "ui/context/ui.h"

namespace coaster::ui {

// In the viewport's upper right corner, while there is a result to show and room for it.
void draw_score_card(Ui& ui, const view::Viewport& scene);

}  // namespace coaster::ui
