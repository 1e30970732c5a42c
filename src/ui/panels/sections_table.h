// The table of sections: sorted by any column, with several rows selected at once.
#pragma once

#include "ui/context/ui.h"
#include "view/camera.h"

namespace coaster::ui {

// Builds the table over `area`, in Build.
void build_sections_table(Ui& ui, const view::Viewport& area);

}  // namespace coaster::ui
