// The table of panels, and the columns they stand in.
#include "ui/panels/panels.h"

#include <imgui.h>

#include <array>

namespace coaster::ui {

std::span<const Panel> panels() {
  static constexpr std::array kPanels{
      // pages: in the order of world::lab_pages()
      Panel{"Track", Column::left, "The track as a whole: its name, file, size, and what can be added.", track_panel},
      Panel{"Inspector", Column::left, "What is selected: a knot, a segment with a place on it, or a cart.",
            inspector_panel},
      Panel{"Shape", Column::left, "What can be done to the selected knots, or to all, at once; snapping.", shape_panel,
            false},
      Panel{"Elements", Column::left,
            "Straights, curves, helices, hills and inversions, placed at the open end of the track.", elements_panel},
      Panel{"Operation", Column::left, "What makes the track a ride: equipment, the train, losses.", operation_panel},
      Panel{"Challenge", Column::right, "The challenge under way: what it teaches, what must hold, and its medals.",
            challenge_panel, true, challenge_shown},
      Panel{"Evaluation", Column::right, "How the curve is turned into a polyline, and how exact and fast that is.",
            evaluation_panel},
      Panel{"Ride", Column::right, "The carts: run them, and read what they do.", ride_panel},
      Panel{"Camera", Column::right, "Where the picture is taken from, and how the camera feels.", camera_panel},
      Panel{"Statistics", Column::right, "What the last frame cost.", statistics_panel},
      Panel{"History", Column::right, "The steps that can be undone and redone; a click goes there.", history_panel,
            false},
      Panel{"Construction", Column::bottom,
            "De Casteljau's construction of the point at the probe: by interpolation alone.", construction_page},
      Panel{"Weights", Column::bottom,
            "Bernstein's basis: how much each control point weighs in the point of the curve.", weights_page},
      Panel{"Hodograph", Column::bottom, "The derivative B'(t) as a curve of its own, and the speed of the parameter.",
            hodograph_page},
      Panel{"Error", Column::bottom, "What rounding does to the chosen evaluator along the segment, in millimetres.",
            error_page},
      Panel{"Lengths", Column::bottom,
            "Every arc-length method on the segment and on the track, and how fast each converges.", lengths_page},
      Panel{"Frames", Column::bottom,
            "How carts are turned along the track; curvature, torsion, and where Frenet-Serret fails.", frames_page},
      Panel{"Joints", Column::bottom,
            "How smoothly the segments join, what a rider feels of it, and buttons that mend it.", joints_page},
      Panel{"Errata", Column::bottom, "What the paper of 2012 claims beside what holds, in numbers of the segment.",
            errata_page},
      Panel{"Measurements", Column::bottom, "Time and error of every evaluator, measured on this machine.",
            measurements_page},
      Panel{"Forces", Column::bottom,
            "The whole ride before it is ridden: speed, height and g, what may not last that long, and ratings.",
            forces_page},
  };
  return kPanels;
}

void build_column(Ui& ui, Column column, const view::Viewport& area) {
  if (area.width < 1 || area.height < 1) return;
  ImGui::SetNextWindowPos({area.x, area.y});
  ImGui::SetNextWindowSize({area.width, area.height});
  constexpr ImGuiWindowFlags kFixed =
      ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoCollapse |
      ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoBringToFrontOnFocus | ImGuiWindowFlags_NoNav;
  if (ImGui::Begin(column == Column::left ? "##left" : "##right", nullptr, kFixed)) {
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
