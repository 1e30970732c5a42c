// The palette of Build: a button for each element, always in the same position.
#pragma once

#include "ui/context/ui.h"
#include "view/camera.h"

namespace coaster::ui {

// The grid of the palette's buttons in its area.
struct PaletteGrid {
  int columns = 1, rows = 1;
  bool labels = false;                    // false: icons only
  float cell_width = 0, cell_height = 0;  // px, without gaps
};

// Returns the number of the palette's buttons.
int palette_size();
// Returns the width of the widest button with a label, px.
float palette_label_width(float scale);
// Draws the palette over `area`. It never scrolls: the grid fits the area.
void build_palette_of_elements(Ui& ui, const view::Viewport& area, const PaletteGrid& grid);
// Draws the button that opens and folds the parameters where there is no space for both.
void build_drawer(Ui& ui, const view::Viewport& area);
// Draws the same buttons in a panel, with labels, as many side by side as fit.
void all_element_buttons(Ui& ui);

}  // namespace coaster::ui
