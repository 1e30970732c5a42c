// Settings of the panels: which parts of the window show, their size and sorting.
#pragma once

#include <cstdint>
#include <span>
#include <tuple>

#include "base/enum_names.h"
#include "world/section_columns.h"
#include "world/setting_row.h"

namespace coaster::world {

// The visible parts of the window, by name in scripts and in the settings file.
enum class Workspace : std::uint8_t { all, build, ride, laboratory };
inline constexpr base::NameRow kWorkspaces[] = {
    {"all", "All", "Every panel."},
    {"build", "Build", "Place elements, change them, and see their forces."},
    {"ride", "Ride", "The view, and a slim bar to ride with."},
    {"laboratory", "Laboratory", "Evaluators, resolution, arc length, and pages about the curves."}};
constexpr std::span<const base::NameRow> rows_of(Workspace) { return kWorkspaces; }

struct Panels {
  bool show_panels = true;
  bool show_laboratory = false;
  float laboratory_height = 0;
  Workspace workspace = Workspace::all;
  float graph_height = 0;
  SectionColumn sections_by = SectionColumn::track;
  bool sections_descending = false;
  friend bool operator==(const Panels&, const Panels&) = default;

  static constexpr auto kRows = std::tuple{
      setting(&Panels::show_panels, "panels", "Whether the panels show.", {.kept_as = "panels"}),
      setting(&Panels::show_laboratory, "laboratory", "Whether the pages of the laboratory show, below the viewport.",
              {.kept_as = "laboratory"}),
      setting(&Panels::laboratory_height, "laboratory_height",
              "Height of the laboratory as a share of the height between menu and status bar. 0: chosen by its page.",
              {.low = 0, .high = 0.75, .kept_as = "laboratory_height"}),
      setting(&Panels::workspace, "workspace", "Panels that show: all, or those to build, to ride or to study curves.",
              {.kept_as = "workspace"}),
      setting(&Panels::graph_height, "graph_height",
              "Height of the force graph in Build as a share of the height between menu and status bar. 0: by the "
              "window's size.",
              {.low = 0, .high = 0.5, .kept_as = "graph_height"}),
      setting(&Panels::sections_by, "sections_by", "Column that the table of sections is sorted by."),
      setting(&Panels::sections_descending, "sections_descending", "Whether its largest values come first.")};
};

}  // namespace coaster::world
