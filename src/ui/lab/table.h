// Tables of numbers in small figures, with headings that stay, units in them and rows that scripts can read and click.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "ui/widgets/widgets.h"

namespace coaster::ui {

inline constexpr std::uint32_t kPlainColour = 0xE6E9EF, kGoodColour = 0x4FB477, kBadColour = 0xE5534B;

struct TableColumn {
  std::string_view title, unit;
  float weight = 1;  // share of the width
  std::string_view tooltip;
};

struct Cell {
  std::string text;
  std::uint32_t colour = kPlainColour;
  bool left = false;         // words on the left, numbers on the right
  std::uint32_t ground = 0;  // 0xRRGGBB behind it; 0: none
  std::uint32_t swatch = 0;  // a square of colour before it: the colour of its curve; 0: none
};

// Begins a table that scrolls within `height` px, with its row of headings. False when it is out of sight: then no
// end_table().
bool begin_table(Ui& ui, std::string_view label, std::span<const TableColumn> columns, float height);
// A row, registered as "Laboratory/label" (kind "item") with `value`; true when it is clicked.
bool table_row(Ui& ui, std::string_view label, std::span<const Cell> cells, bool selected, std::string value,
               std::string_view tooltip);
void end_table();

}  // namespace coaster::ui
