// Shows what a drag snaps to, next to the cursor.
#pragma once

#include "ui/context/ui.h"
#include "ui/tools/transform_math.h"

namespace coaster::ui {

// Draws "Snap: grid 1 m" or "Snap: off" while knots are moved, rotated or scaled; the widget "Cursor/Snapping".
void draw_snap_label(Ui& ui, TransformKind kind, world::SnapTo to);

}  // namespace coaster::ui
