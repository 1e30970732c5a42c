// Where menu, panels, status bar and viewport lie.
#include "ui/host/layout.h"

#include <algorithm>
#include <cmath>

namespace coaster::ui {
namespace {

using view::Viewport;
using world::Workspace;

constexpr float kLeft = 300, kRight = 320, kLargestPart = 0.59f;  // design px; of the width, both columns

float strip_height(float height, float scale, float bar, float middle, Strip strip) {
  constexpr float kDesign = 190, kPart = 0.26f, kMost = 0.5f, kLeast = 4;  // kLeast: bars
  if (middle < kLeast * bar) return 0;
  const float usual = std::min(std::max(kDesign * scale, kPart * height), kMost * middle);
  const float wanted = std::floor(strip.share > 0 ? std::max(strip.share * middle, kLeast * bar) : usual);
  return strip.open && wanted >= kLeast * bar ? wanted : bar;
}

// The laboratory's strip below the scene, which has the area so far.
void add_strip(Layout& layout, float height) {
  const Viewport whole = layout.scene;
  layout.scene.height -= height;
  layout.strip = {whole.x, whole.y + layout.scene.height, whole.width, height};
}

void lay_out_all(Layout& layout, float width, float height, float scale, float bar, const LayoutWish& wish) {
  const Viewport middle = layout.scene;
  const float both = std::min((kLeft + kRight) * scale, width * kLargestPart);
  const float left = std::floor(both * kLeft / (kLeft + kRight)), right = std::floor(both * kRight / (kLeft + kRight));
  layout.left = {0, middle.y, left, middle.height};
  layout.right = {width - right, middle.y, right, middle.height};
  layout.scene = {left, middle.y, std::max(1.0f, width - left - right), middle.height};
  add_strip(layout, strip_height(height, scale, bar, middle.height, wish.strip));
}

void lay_out_laboratory(Layout& layout, float width, float height, float scale, float bar, const LayoutWish& wish) {
  const Viewport middle = layout.scene;
  const float right = std::floor(std::min(kRight * scale, 0.5f * kLargestPart * width));
  layout.right = {width - right, middle.y, right, middle.height};
  layout.scene.width -= right;
  add_strip(layout, strip_height(1.4f * height, scale, bar, middle.height, wish.strip));
}

// In a column of this size: with labels where they fill no more than two fifths of it.
PaletteGrid grid_in(float width, float height, float scale, const LayoutWish& wish, bool may_label) {
  constexpr float kIcon = 34, kLabelled = 40, kGap = 4, kMostForLabels = 0.42f;
  const float gap = kGap * scale;
  const auto grid = [&](int columns, bool labels) {
    columns = std::clamp(columns, 1, std::max(1, wish.elements));
    const float each = (width - gap * static_cast<float>(columns - 1)) / static_cast<float>(columns);
    return PaletteGrid{columns, (wish.elements + columns - 1) / columns, labels, std::floor(each),
                       std::floor((labels ? kLabelled : kIcon) * scale)};
  };
  if (may_label && wish.label_width > 0) {
    const PaletteGrid labelled = grid(static_cast<int>((width + gap) / (wish.label_width + gap)), true);
    const float rows = static_cast<float>(labelled.rows);
    if (labelled.cell_width >= wish.label_width && rows * (labelled.cell_height + gap) <= kMostForLabels * height)
      return labelled;
  }
  return grid(static_cast<int>((width + gap) / ((kIcon + kGap) * scale)), false);
}

void lay_out_graph(Layout& layout, float width, float height, float scale, float bar, const LayoutWish& wish) {
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

// Palette and parameters take a column at the left; folded, the palette alone a narrow one.
void lay_out_build(Layout& layout, float width, float height, float scale, float bar, const LayoutWish& wish) {
  constexpr float kColumn = 228, kPad = 8, kIcon = 34, kGap = 4, kRoomy = 1000;
  lay_out_graph(layout, width, height, scale, bar, wish);
  Viewport& scene = layout.scene;
  const bool roomy = width >= kRoomy * scale, open = wish.parameters.value_or(roomy);
  const float pad = std::floor(kPad * scale), drawer = roomy && open ? 0 : std::min(bar, scene.height);
  const float cell = (kIcon + kGap) * scale, room = std::max(cell, scene.height - drawer - 2 * pad);
  const int columns_of_icons =
      std::max(2, static_cast<int>(std::ceil(static_cast<float>(wish.elements) * cell / room)));
  const float narrow = static_cast<float>(columns_of_icons) * cell + 2 * pad;
  const float column = std::floor(std::min(std::max(narrow, open ? kColumn * scale : 0), 0.5f * width));
  layout.grid = grid_in(column - 2 * pad, scene.height, scale, wish, open);
  const float wanted = static_cast<float>(layout.grid.rows) * (layout.grid.cell_height + kGap * scale) + 2 * pad;
  const float palette = open ? std::min(std::floor(wanted), scene.height - drawer) : scene.height - drawer;
  layout.palette = {0, scene.y, column, palette};
  layout.drawer = {0, scene.y + palette, column, drawer};
  if (open) layout.parameters = {0, scene.y + palette + drawer, column, scene.height - palette - drawer};
  scene.x += column, scene.width -= column;
}

void lay_out_ride(Layout& layout, float width, float scale, float bar) {
  constexpr float kRoomy = 1240, kPad = 8;
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

Layout make_layout(int width, int height, float scale, float bar, const LayoutWish& wish) {
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
