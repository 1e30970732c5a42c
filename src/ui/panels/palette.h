// The palette of Build: a button for each element, always in the same place.
#pragma once

#include "ui/context/ui.h"
#include "view/camera.h"

namespace coaster::ui {

// How the palette's buttons lie in its area.
struct PaletteGrid {
  int columns = 1, rows = 1;
  bool labels = false;                    // else icons alone
  float cell_width = 0, cell_height = 0;  // px, without the gaps
};

// Number of the palette's buttons.
int palette_size();
// Width of the widest button with a label, px.
float palette_label_width(float scale);
// Over `area`. Never scrolls: the grid fits the area.
void build_palette_of_elements(Ui& ui, const view::Viewport& area, const PaletteGrid& grid);
// The button that opens and folds the parameters where there is little room for both.
void build_drawer(Ui& ui, const view::Viewport& area);
// The same buttons in a panel, with labels, as many beside each other as find room.
void all_element_buttons(Ui& ui);

}  // namespace coaster::ui
