// Computes the layout of menu, panels, status bar and viewport.
#include "ui/host/layout.h"

#include <algorithm>
#include <cmath>

namespace coaster::ui {
namespace {

using view::Viewport;
using world::Workspace;

constexpr float kLeft = 300, kRight = 320,
                kLargestPart = 0.59f;  // design px; fraction of the width for both columns together

float strip_height(float height, float scale, float bar, float middle, Strip strip) {
  constexpr float kDesign = 190, kPart = 0.26f, kMost = 0.5f, kLeast = 4;  // kLeast: bars
  if (middle < kLeast * bar) return 0;
  const float usual = std::min(std::max(kDesign * scale, kPart * height), kMost * middle);
  const float wanted = std::floor(strip.share > 0 ? std::max(strip.share * middle, kLeast * bar) : usual);
  return strip.open && wanted >= kLeast * bar ? wanted : bar;
}

// Adds the laboratory's strip below the scene, taking its height from the scene's area.
void add_strip(Layout& layout, float height) {
  const Viewport whole = layout.scene;
  layout.scene.height -= height;
  layout.strip = {whole.x, whole.y + layout.scene.height, whole.width, height};
}

void lay_out_all(Layout& layout, float width, float height, float scale, float bar, const LayoutOptions& wish) {
  const Viewport middle = layout.scene;
  const float both = std::min((kLeft + kRight) * scale, width * kLargestPart);
  const float left = std::floor(both * kLeft / (kLeft + kRight)), right = std::floor(both * kRight / (kLeft + kRight));
  layout.left = {0, middle.y, left, middle.height};
  layout.right = {width - right, middle.y, right, middle.height};
  layout.scene = {left, middle.y, std::max(1.0f, width - left - right), middle.height};
  add_strip(layout, strip_height(height, scale, bar, middle.height, wish.strip));
}

void lay_out_laboratory(Layout& layout, float width, float height, float scale, float bar, const LayoutOptions& wish) {
  const Viewport middle = layout.scene;
  const float right = std::floor(std::min(kRight * scale, 0.5f * kLargestPart * width));
  layout.right = {width - right, middle.y, right, middle.height};
  layout.scene.width -= right;
  add_strip(layout, strip_height(1.4f * height, scale, bar, middle.height, wish.strip));
}

// Sizes of the palette, design px; kColumn: of palette and parameters together.
constexpr float kColumn = 228, kPad = 8, kGap = 4, kIcon = 34, kLabelled = 36;

PaletteGrid grid_of(int columns, bool labels, float width, float scale, int elements) {
  columns = std::clamp(columns, 1, std::max(1, elements));
  const float each = (width - kGap * scale * static_cast<float>(columns - 1)) / static_cast<float>(columns);
  return {columns, (elements + columns - 1) / columns, labels, std::floor(each),
          std::floor((labels ? kLabelled : kIcon) * scale)};
}
float height_of(const PaletteGrid& grid, float scale) {
  return static_cast<float>(grid.rows) * (grid.cell_height + kGap * scale) + 2 * std::floor(kPad * scale);
}

// Returns the grid in a column of `width` px above the parameters: with labels if the parameters keep a legible height.
PaletteGrid grid_above(float width, float height, float scale, const LayoutOptions& wish) {
  constexpr float kParameters = 110;  // design px
  const float gap = kGap * scale;
  if (const auto columns = static_cast<int>((width + gap) / (wish.label_width + gap)); columns > 0) {
    const PaletteGrid labelled = grid_of(columns, true, width, scale, wish.elements);
    if (height_of(labelled, scale) <= height - kParameters * scale) return labelled;
  }
  return grid_of(static_cast<int>((width + gap) / ((kIcon + kGap) * scale)), false, width, scale, wish.elements);
}

// Returns the grid alone in a column of `height` px: as narrow as possible for all buttons, with labels unless that is
// wider than kColumn, and never wider than `most` px.
PaletteGrid grid_alone(float height, float most, float scale, const LayoutOptions& wish) {
  const float gap = kGap * scale, labelled = std::min(most, kColumn * scale - 2 * std::floor(kPad * scale));
  for (const bool labels : {true, false}) {
    const float cell = labels ? std::ceil(wish.label_width) : kIcon * scale, limit = labels ? labelled : most;
    for (int columns = labels ? 1 : 2; static_cast<float>(columns) * (cell + gap) - gap <= limit; ++columns) {
      const float width = static_cast<float>(columns) * (cell + gap) - gap;
      const PaletteGrid grid = grid_of(columns, labels, width, scale, wish.elements);
      if (height_of(grid, scale) <= height) return grid;
      if (grid.rows == 1) break;
    }
  }
  return grid_of(static_cast<int>((most + gap) / (kIcon * scale + gap)), false, most, scale, wish.elements);
}

void lay_out_graph(Layout& layout, float width, float height, float scale, float bar, const LayoutOptions& wish) {
  constexpr float kDesign = 130, kPart = 0.17f, kMost = 0.5f, kLeast = 4, kRoomy = 600;  // kLeast: bars
  Viewport& scene = layout.scene;
  if (scene.height < kLeast * bar) return;
  const bool roomy = height >= kRoomy * scale && kMost * scene.height >= kLeast * bar;
  const float usual = std::max(kDesign * scale, kPart * height);
  const float wanted = wish.graph_share > 0 ? wish.graph_share * scene.height : usual;
  const float most = std::max(bar, kMost * scene.height);
  const float open = std::clamp(std::floor(wanted), std::min(kLeast * bar, most), most);
  const float graph = wish.graph.value_or(roomy) ? std::floor(open) : bar;
  scene.height -= graph;
  layout.graph = {0, scene.y + scene.height, width, graph};
}

// Palette and parameters share a column at the left; when the parameters are folded, the palette has a narrow column.
void lay_out_build(Layout& layout, float width, float height, float scale, float bar, const LayoutOptions& wish) {
  constexpr float kRoomy = 850;  // the column takes at most 27 % of the width
  lay_out_graph(layout, width, height, scale, bar, wish);
  Viewport& scene = layout.scene;
  const bool roomy = width >= kRoomy * scale, open = wish.parameters.value_or(roomy);
  const float pad = std::floor(kPad * scale), drawer = roomy && open ? 0 : std::min(bar, scene.height);
  const float room = scene.height - drawer;
  float column = kColumn * scale;
  if (!open) {
    layout.grid = grid_alone(room, 0.5f * width - 2 * pad, scale, wish);
    const auto columns = static_cast<float>(layout.grid.columns);
    column = std::ceil(columns * (layout.grid.cell_width + kGap * scale) - kGap * scale) + 2 * pad;
  }
  column = std::floor(std::min(column, 0.5f * width));
  if (open) layout.grid = grid_above(column - 2 * pad, room, scale, wish);
  const float palette = open ? std::min(std::floor(height_of(layout.grid, scale)), room) : room;
  layout.palette = {0, scene.y, column, palette};
  layout.drawer = {0, scene.y + palette, column, drawer};
  if (open) layout.parameters = {0, scene.y + palette + drawer, column, room - palette};
  scene.x += column, scene.width -= column;
}

void lay_out_ride(Layout& layout, float width, float scale, float bar) {
  constexpr float kRoomy = 1240;
  const float rows = width >= kRoomy * scale ? 1 : 2;
  const float ride = std::min(std::floor(rows * bar + (rows + 1) * kPad * scale), 0.5f * layout.scene.height);
  layout.scene.height -= ride;
  layout.ride = {0, layout.scene.y + layout.scene.height, width, ride};
}

}  // namespace

float fitted_scale(int width, int height, float ui_scale, float content_scale) {
  constexpr float kRoomyWidth = 1000, kRoomyHeight = 560, kSmallest = 0.8f;  // 12 px text: still legible
  const float fit =
      std::min(static_cast<float>(width) / kRoomyWidth, static_cast<float>(height) / kRoomyHeight) / content_scale;
  return ui_scale * content_scale * std::clamp(fit, kSmallest, 1.0f);
}

Layout make_layout(int width, int height, float scale, float bar, const LayoutOptions& wish) {
  const float w = static_cast<float>(width), h = static_cast<float>(height);
  Layout layout;
  layout.scene = {0, 0, w, h};
  if (!wish.panels) return layout;
  const float top = std::min(bar, h), bottom = std::max(top, h - bar);
  layout.menu = {0, 0, w, top};
  layout.status = {0, bottom, w, h - bottom};
  layout.scene = {0, top, w, std::max(1.0f, bottom - top)};
  switch (wish.workspace) {
    case Workspace::all: lay_out_all(layout, w, h, scale, bar, wish); break;
    case Workspace::build: lay_out_build(layout, w, h, scale, bar, wish); break;
    case Workspace::ride: lay_out_ride(layout, w, scale, bar); break;
    case Workspace::laboratory: lay_out_laboratory(layout, w, h, scale, bar, wish); break;
  }
  return layout;
}

}  // namespace coaster::ui
