// The table of panels. To add one: a function in its own file and a row in panels.cpp.
#pragma once

#include <span>
#include <string_view>

#include "ui/widgets/widgets.h"

namespace coaster::ui {

enum class Column { left, right, bottom };  // bottom: pages of the laboratory, one at a time

struct Panel {
  std::string_view name;  // first part of its widgets' paths; that of all pages is "Laboratory"
  Column column;
  std::string_view help;
  void (*build)(Ui& ui);
  bool open = true;                       // at first
  bool (*shown)(const Ui& ui) = nullptr;  // null: always
};
std::span<const Panel> panels();

void challenge_panel(Ui& ui);
bool challenge_shown(const Ui& ui);
void track_panel(Ui& ui);
void inspector_panel(Ui& ui);
void shape_panel(Ui& ui);
void evaluation_panel(Ui& ui);
void ride_panel(Ui& ui);
void camera_panel(Ui& ui);
void operation_panel(Ui& ui);
void elements_panel(Ui& ui);
void statistics_panel(Ui& ui);
void history_panel(Ui& ui);

void construction_page(Ui& ui);
void weights_page(Ui& ui);
void hodograph_page(Ui& ui);
void error_page(Ui& ui);
void lengths_page(Ui& ui);
void frames_page(Ui& ui);
void joints_page(Ui& ui);
void errata_page(Ui& ui);
void measurements_page(Ui& ui);
void forces_page(Ui& ui);

// The panels of one column, one under the other, in a window of their own over `area`; scrolls.
void build_column(Ui& ui, Column column, const view::Viewport& area);
// The laboratory: a bar with the names of its pages, and below it, while the strip is open, the chosen one.
void build_laboratory(Ui& ui, const view::Viewport& area);
void build_status_bar(Ui& ui, const view::Viewport& area);

}  // namespace coaster::ui
