// Builds the panels in the areas of the layout, for each workspace.
#pragma once

#include "ui/context/ui.h"
#include "ui/host/layout.h"

namespace coaster::ui {

LayoutWish wish_of(const Ui& ui);
// Builds everything except the menu. Empty areas are skipped.
void build_areas(Ui& ui, const Layout& layout);

}  // namespace coaster::ui
