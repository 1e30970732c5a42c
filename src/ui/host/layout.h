// Layout of menu, columns, laboratory, status bar and viewport in a window. Nothing overlaps; the viewport gets the
// rest.
#pragma once

#include "view/camera.h"

namespace coaster::ui {

struct Layout {
  view::Viewport menu, left, right, strip, status;  // without area while the panels are hidden
  view::Viewport scene;
};

// Pixels per design pixel: the user's scale times the screen's, somewhat smaller in windows below 1000 x 560.
float fitted_scale(int width, int height, float ui_scale, float content_scale);

// The laboratory's strip: whether it is open, and its share of the height between menu and status bar (0: chosen by the
// layout).
struct Strip {
  bool open = false;
  float share = 0;
};

// `bar` is the height of menu bar and status bar, px. Columns get 300 and 320 design pixels, together at most 60 % of
// the width. The laboratory's strip lies between them: a bar while folded; open, its share, else the larger of 190
// design pixels and a quarter of the window, but at most half the height between menu and status bar. It stays folded
// where that is too low.
Layout make_layout(int width, int height, float scale, float bar, bool show_panels, Strip strip);

}  // namespace coaster::ui
