// The columns of panels next to the scene, and the bars.
#pragma once

#include <span>
#include <string_view>

#include "ui/context/ui.h"
#include "view/camera.h"

namespace coaster::ui {

enum class PanelColumn { left, right };

// When a panel shows in a workspace other than `all`, which shows every panel. In Build: while an element is selected,
// a section or something else is selected, or neither; in the laboratory.
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
  PanelColumn column;     // its column in `all`
  unsigned shows;         // occasions, in addition to `all`
  std::string_view help;
  void (*build)(Ui& ui);
  bool open = true;                       // initially
  bool (*shown)(const Ui& ui) = nullptr;  // null: always
};
std::span<const Panel> panels();

// Builds the panels of one column, one below the other, in a scrolling window over `area`. Build and the laboratory
// have only one column, with all their panels.
void build_column(Ui& ui, PanelColumn column, const view::Viewport& area);
void build_status_bar(Ui& ui, const view::Viewport& area);
// Draws the current challenge's goals and the limits that are broken in the upper right corner of the scene. The mouse
// reaches the scene behind it.
void draw_goals(Ui& ui, const view::Viewport& scene);

// Parts of the panel Evaluation that also show in the list of the status bar.
void evaluator_choice(Ui& ui);
void steps_slider(Ui& ui);

// Builds it in one row, or in two if the area is high enough.
void build_ride_bar(Ui& ui, const view::Viewport& area);

}  // namespace coaster::ui
