// The table of panels. To add one: a function in its own file and a row in panels.cpp.
#pragma once

#include <span>
#include <string_view>

#include "ui/widgets.h"

namespace coaster::ui {

enum class Column { left, right };

struct Panel {
  std::string_view name;  // first part of its widgets' paths
  Column column;
  std::string_view help;
  void (*build)(Ui& ui);
};
std::span<const Panel> panels();

void track_panel(Ui& ui);
void inspector_panel(Ui& ui);
void evaluation_panel(Ui& ui);
void ride_panel(Ui& ui);
void statistics_panel(Ui& ui);

// The panels of one column, one under the other, in a window of their own over `area`; scrolls.
void build_column(Ui& ui, Column column, const view::Viewport& area);
void build_status_bar(Ui& ui, const view::Viewport& area);

}  // namespace coaster::ui
