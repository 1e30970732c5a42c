// The table of panels, and their columns. To add a panel: a file with its function, and a row here.
#include "ui/panels/panels.h"

#include <imgui.h>

#include <array>

namespace coaster::ui {

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

std::span<const Panel> panels() {
  static constexpr std::array kPanels{
      Panel{"Track", Column::left, "The whole track: name, file, size, and what you can add.", track_panel},
      Panel{"Inspector", Column::left, "The selected knot, segment or cart.", inspector_panel},
      Panel{"Shape", Column::left, "Operations on the selected knots or on all knots, and snapping.", shape_panel,
            false},
      Panel{"Elements", Column::left,
            "Straights, curves, helices, hills and inversions to place at the open end of the track.", elements_panel},
      Panel{"Operation", Column::left, "Equipment, train and losses.", operation_panel},
      Panel{"Challenge", Column::right, "The current challenge: goals, limits and medals.", challenge_panel, true,
            challenge_shown},
      Panel{"Evaluation", Column::right, "How curves become polylines: method, resolution, accuracy and speed.",
            evaluation_panel},
      Panel{"Ride", Column::right, "Run the carts and read their speed, height and g.", ride_panel},
      Panel{"Camera", Column::right, "Camera modes and camera feel.", camera_panel},
      Panel{"Statistics", Column::right, "Cost of the last frame.", statistics_panel},
      Panel{"History", Column::right, "Undo and redo steps. Click a step to go to it.", history_panel, false},
  };
  return kPanels;
}

void build_column(Ui& ui, Column column, const view::Viewport& area) {
  if (area.width < 1 || area.height < 1) return;
  if (begin_area(column == Column::left ? "##left" : "##right", {area.x, area.y}, {area.width, area.height}, 0)) {
    for (const Panel& panel : panels()) {
      if (panel.column != column || (panel.shown != nullptr && !panel.shown(ui))) continue;
      ui.panel = panel.name;
      ImGui::PushID(panel.name.data(), panel.name.data() + panel.name.size());
      if (header(ui, panel.name, panel.help, panel.open)) panel.build(ui);
      ImGui::PopID();
    }
  }
  ImGui::End();
  ui.panel.clear();
}

}  // namespace coaster::ui
