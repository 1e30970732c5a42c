// The bar of the workspace Ride: running the ride, its values, scrubbing, seat, camera and recording.
#pragma once

#include "ui/context/ui.h"
#include "view/camera.h"

namespace coaster::ui {

// In one row, or in two where the area is high enough for them.
void build_ride_bar(Ui& ui, const view::Viewport& area);

}  // namespace coaster::ui
