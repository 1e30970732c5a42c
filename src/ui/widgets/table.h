// Tables in the small font with fixed headings, units, and rows that scripts can read and click; a heading may sort.
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
  float weight = 1;              // share of the width
  std::string_view tooltip;
  bool words = false;  // on the left, as its cells
};

struct Cell {
  std::string text;
  std::uint32_t colour = kPlainColour;
  bool left = false;         // words on the left, numbers on the right
  std::uint32_t ground = 0;  // 0xRRGGBB behind it; 0: none
  std::uint32_t swatch = 0;  // a square of colour before it: the colour of its curve; 0: none
};

// What every table is drawn with: the small font and `gap` design px above and below a row.
inline constexpr ImGuiTableFlags kTableFlags =
    ImGuiTableFlags_ScrollY | ImGuiTableFlags_RowBg | ImGuiTableFlags_SizingStretchProp | ImGuiTableFlags_PadOuterX;
void push_table_style(const WidgetFrame& ui, float gap);
void pop_table_style();

// The column that the rows are sorted by, marked by a triangle that points up where values rise downwards.
struct Sorting {
  int column = 0;
  bool descending = false;
  std::optional<int> clicked;  // by begin_table(): the heading that the user clicked
};

// Begins a table of `height` px with scrolling rows. Returns false if it is out of sight: do not call end_table() then.
// With `sorting` its headings are buttons.
bool begin_table(WidgetFrame& ui, std::string_view label, std::span<const TableColumn> columns, float height,
                 Sorting* sorting = nullptr);
// Adds a row, registered as "Panel/label" (kind "item") with `value`. Returns true if it is clicked. While one of its
// cells is typed in it is not `clickable`.
bool table_row(WidgetFrame& ui, std::string_view label, std::span<const Cell> cells, bool selected, std::string value,
               std::string_view tooltip, bool clickable = true);
void end_table();

}  // namespace coaster::ui
