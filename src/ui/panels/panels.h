// The columns of panels beside the scene, and the status bar.
#pragma once

#include <span>
#include <string_view>

#include "ui/context/ui.h"

namespace coaster::ui {

enum class Column { left, right };

// When a panel shows in a workspace other than `all`, which shows every panel: in Build while an element is chosen, a
// section or something else is selected, or neither; in the laboratory.
enum Occasion : unsigned {
  kElement = 1,
  kSelection = 2,
  kTrack = 4,
  kSection = 8,
  kWhileBuilding = 15,
  kLaboratory = 16
};

struct Panel {
  std::string_view name;  // first part of its widgets' paths
  Column column;          // in `all`
  unsigned shows;         // occasions, beside `all`
  std::string_view help;
  void (*build)(Ui& ui);
  bool open = true;                       // at first
  bool (*shown)(const Ui& ui) = nullptr;  // null: always
};
std::span<const Panel> panels();

// The panels of one column, one under the other, in one scrolling window over `area`. In Build and in the laboratory
// there is only one column, with all that belongs there.
void build_column(Ui& ui, Column column, const view::Viewport& area);
void build_status_bar(Ui& ui, const view::Viewport& area);

// Parts of the panel Evaluation that the status bar's list has, too.
void evaluator_choice(Ui& ui);
void steps_slider(Ui& ui);

}  // namespace coaster::ui
