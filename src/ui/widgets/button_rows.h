// Buttons of equal width in rows.
#pragma once

#include <string_view>

#include "ui/widgets/widgets.h"

namespace coaster::ui {

struct ButtonRows {
  WidgetFrame& ui;
  int columns;              // buttons in a row, or fewer where the widest label does not fit
  std::string_view widest;  // label
  int placed = 0;
  float width = 0;  // px, of a button; set with the first one

  // Adds a button; returns whether it is pressed.
  bool operator()(std::string_view label, std::string_view tooltip, bool enabled = true);
};

}  // namespace coaster::ui
