// Tables in the small font with fixed headings, units, and rows that scripts can read and click; a heading can sort.
#pragma once

#include <imgui.h>

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "ui/widgets/widgets.h"

namespace coaster::ui {

inline constexpr std::uint32_t kPlainColour = 0xE6E9EF, kGoodColour = 0x4FB477, kBadColour = 0xE5534B;

struct TableColumn {
  std::string_view title, unit;  // unit: metric. A heading too narrow for both has the unit in its tooltip.
  float width = 60;              // design px, the least; columns share the remaining room in this proportion
  std::string_view tooltip;
  bool words = false;  // left-aligned text, as are its cells
};

struct Cell {
  std::string text;
  std::uint32_t colour = kPlainColour;
  bool left = false;         // left-aligned text; numbers are right-aligned
  std::uint32_t ground = 0;  // background, 0xRRGGBB; 0: none
  std::uint32_t swatch = 0;  // a coloured square before the text: the colour of its curve; 0: none
};

// Style of every table: the small font and `gap` design px above and below a row.
inline constexpr ImGuiTableFlags kTableFlags =
    ImGuiTableFlags_ScrollY | ImGuiTableFlags_RowBg | ImGuiTableFlags_SizingStretchProp | ImGuiTableFlags_PadOuterX;
void push_table_style(const WidgetFrame& ui, float gap);
void pop_table_style();

// The column that sorts the rows, marked by a triangle that points up for ascending values.
struct Sorting {
  int column = 0;
  bool descending = false;
  std::optional<int> clicked;  // set by begin_table(): the heading that the user clicked
};

// Begins a table of `height` px with scrolling rows; one that is too narrow for its columns scrolls sideways. Returns
// false if it is not visible; then do not call end_table(). With `sorting` its headings are buttons.
bool begin_table(WidgetFrame& ui, std::string_view label, std::span<const TableColumn> columns, float height,
                 Sorting* sorting = nullptr);
// Adds a row, registered as "Panel/label" (kind "item") with `value`. Returns true if it is clicked. It is not
// `clickable` while one of its cells is edited.
bool table_row(WidgetFrame& ui, std::string_view label, std::span<const Cell> cells, bool selected, std::string value,
               std::string_view tooltip, bool clickable = true);
void end_table();

// Calls row(i) for the rows that are in sight, of `count` equally high ones. Returns the height of a row, px.
template <class Row>
float each_row_in_sight(std::size_t count, Row row) {
  ImGuiListClipper clipper;
  clipper.Begin(static_cast<int>(count));
  while (clipper.Step())
    for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) row(static_cast<std::size_t>(i));
  return clipper.ItemsHeight;
}

}  // namespace coaster::ui
