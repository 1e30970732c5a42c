// The bar of the workspace Ride: playback, values, scrubbing, seat, camera and recording.
#pragma once

#include "ui/context/ui.h"
#include "view/camera.h"

namespace coaster::ui {

// Builds it in one row, or in two if the area is high enough.
void build_ride_bar(Ui& ui, const view::Viewport& area);

}  // namespace coaster::ui
