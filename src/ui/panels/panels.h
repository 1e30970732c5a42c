// The columns of panels beside the scene, and the status bar.
#pragma once

#include <span>
#include <string_view>

#include "ui/context/ui.h"

namespace coaster::ui {

enum class Column { left, right };

struct Panel {
  std::string_view name;  // first part of its widgets' paths
  Column column;
  std::string_view help;
  void (*build)(Ui& ui);
  bool open = true;                       // at first
  bool (*shown)(const Ui& ui) = nullptr;  // null: always
};
std::span<const Panel> panels();

// The panels of one column, one under the other, in one scrolling window over `area`.
void build_column(Ui& ui, Column column, const view::Viewport& area);
void build_status_bar(Ui& ui, const view::Viewport& area);

}  // namespace coaster::ui
