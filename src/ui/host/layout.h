// The layout of menu, panels, status bar and viewport in a window, for each workspace. Areas do not overlap; the
// viewport gets the rest.
#pragma once

#include <optional>

#include "ui/panels/palette.h"
#include "view/camera.h"
#include "world/panel_settings.h"

namespace coaster::ui {

inline constexpr view::Viewport kNothing{0, 0, 0, 0};

struct Layout {
  // Areas are kNothing in workspaces that do not show them.
  view::Viewport menu = kNothing, status = kNothing;
  view::Viewport left = kNothing, right = kNothing, strip = kNothing;  // columns, and the strip of the laboratory
  // The areas of Build. The drawer is the button that opens and closes the parameters where space is short.
  view::Viewport palette = kNothing, drawer = kNothing, parameters = kNothing, graph = kNothing;
  view::Viewport ride = kNothing;  // the bar of Ride
  view::Viewport scene = kNothing;
  PaletteGrid grid;  // the palette's grid
};

// Returns pixels per design pixel: the user's scale times the screen's, reduced in windows below 1000 x 560.
float fitted_scale(int width, int height, float ui_scale, float content_scale);

// A part that folds to a bar, and its share of the height between menu and status bar (0: default).
struct Strip {
  bool open = false;
  float share = 0;
};

struct LayoutOptions {
  bool panels = true;
  world::Workspace workspace = world::Workspace::all;
  Strip strip = {};
  std::optional<bool> parameters = {}, graph = {};  // Build: whether they are open; nothing: if there is space
  float graph_share = 0;                            // 0: default
  int elements = 0;                                 // number of buttons of the palette
  float label_width = 0;                            // px, of the widest button with a label
};

// `bar` is the height of menu bar and status bar, px.
// - All: columns of 300 and 320 design pixels, together at most 60 % of the width. The laboratory's strip lies between
//   them: a bar while folded; open, its share, else the larger of 190 design pixels and a quarter of the window, but at
//   most half the height between menu and status bar. It stays folded where that is too low.
// - Build: palette and, below it, parameters in a column of 228 design pixels; the graph over the whole width.
//   Parameters fold below 850 design pixels of width, the graph below 600 of height. The palette's buttons have labels
//   where parameters keep 110 design pixels of height or, folded, where the column is no wider.
// - Ride: a bar over the whole width, of two rows below 1240 design pixels.
// - Laboratory: the right column and the strip, which begins at the left edge.
Layout make_layout(int width, int height, float scale, float bar, const LayoutOptions& wish);

}  // namespace coaster::ui
