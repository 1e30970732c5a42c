// The panels in the areas of the layout: what each workspace shows, and how its parts are open.
#pragma once

#include "ui/context/ui.h"
#include "ui/host/layout.h"

namespace coaster::ui {

LayoutWish wish_of(const Ui& ui);
// Everything but the menu. Areas without size are left out.
void build_areas(Ui& ui, const Layout& layout);

}  // namespace coaster::ui
