// The table of panels, and the columns they stand in.
#include "ui/panels.h"

#include <imgui.h>

#include <array>

namespace coaster::ui {

std::span<const Panel> panels() {
  static constexpr std::array kPanels{
      Panel{"Track", Column::left, "The track as a whole: its name, file, size, and what can be added.", track_panel},
      Panel{"Inspector", Column::left, "What is selected: a knot, a segment with a place on it, or a cart.", inspector_panel},
      Panel{"Evaluation", Column::right, "How the curve is turned into a polyline, and how exact and fast that is.", evaluation_panel},
      Panel{"Ride", Column::right, "The carts: run them, and read what they do.", ride_panel},
      Panel{"Statistics", Column::right, "What the last frame cost.", statistics_panel},
  };
  return kPanels;
}

void build_column(Ui& ui, Column column, const view::Viewport& area) {
  if (area.width < 1 || area.height < 1) return;
  ImGui::SetNextWindowPos({area.x, area.y});
  ImGui::SetNextWindowSize({area.width, area.height});
  constexpr ImGuiWindowFlags kFixed = ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoResize |
                                      ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoBringToFrontOnFocus |
                                      ImGuiWindowFlags_NoNav;
  if (ImGui::Begin(column == Column::left ? "##left" : "##right", nullptr, kFixed)) {
    for (const Panel& panel : panels()) {
      if (panel.column != column) continue;
      ui.panel = panel.name;
      ImGui::PushID(panel.name.data(), panel.name.data() + panel.name.size());
      if (header(ui, panel.name, panel.help)) panel.build(ui);
      ImGui::PopID();
    }
  }
  ImGui::End();
  ui.panel.clear();
}

}  // namespace coaster::ui
