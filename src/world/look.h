// Settings of the window: how it looks and sounds, and which parts of it show.
#pragma once

#include <cstdint>
#include <span>

#include "base/names.h"
#include "base/units.h"
#include "world/section_columns.h"
#include "world/setting_row.h"

namespace coaster::world {

// Colours of the panels; by name in scripts and in the settings file.
enum class Theme : std::uint8_t { dark, light, high_contrast };
inline constexpr base::NameRow kThemes[] = {{"dark", "Dark", "Colours of the panels."},
                                            {"light", "Light", "Colours of the panels."},
                                            {"high_contrast", "High contrast", "Colours of the panels."}};
constexpr std::span<const base::NameRow> rows_of(Theme) { return kThemes; }

// Light, sky and ground of the scene; by name in scripts and in the settings file.
enum class Style : std::uint8_t { day, dusk, blueprint };
inline constexpr base::NameRow kStyles[] = {
    {"day", "Day", "High sun, clear sky."},
    {"dusk", "Dusk", "Low sun, long shadows."},
    {"blueprint", "Blueprint", "Lines on blue, for the laboratory and for print."}};
constexpr std::span<const base::NameRow> rows_of(Style) { return kStyles; }

// What of the panels shows; by name in scripts and in the settings file.
enum class Workspace : std::uint8_t { all, build, ride, laboratory };
inline constexpr base::NameRow kWorkspaces[] = {
    {"all", "All", "Every panel."},
    {"build", "Build", "Place elements, change them, and see their forces."},
    {"ride", "Ride", "The view, and a slim bar to ride with."},
    {"laboratory", "Laboratory", "Evaluators, resolution, arc length, and pages about the curves."}};
constexpr std::span<const base::NameRow> rows_of(Workspace) { return kWorkspaces; }

struct Look {
  float ui_scale = 1;
  Theme theme = Theme::dark;
  Style style = Style::day;
  base::Units units = base::Units::m_s;
  bool shadows = true;
  float sound = 0.5f;
  bool show_panels = true;
  bool show_laboratory = false;
  float laboratory_height = 0;
  Workspace workspace = Workspace::all;
  float graph_height = 0;
  SectionColumn sections_by = SectionColumn::track;
  bool sections_descending = false;
  friend bool operator==(const Look&, const Look&) = default;

  static constexpr auto kRows = std::tuple{
      setting(&Look::ui_scale, "scale", "Scale of the panels.", {.low = 0.75, .high = 3, .kept_as = "ui_scale"}),
      setting(&Look::theme, "theme", "Colours of the panels.", {.kept_as = "theme"}),
      setting(&Look::style, "style", "Light of the scene.", {.kept_as = "style"}),
      setting(&Look::units, "units", "Units that lengths and speeds are shown and typed in. Scripts stay metric.",
              {.kept_as = "units"}),
      setting(&Look::shadows, "shadows", "Whether track and trains cast shadows. Frames cost less without them.",
              {.kept_as = "shadows"}),
      setting(&Look::sound, "sound", "Ride volume. 0 mutes it.", {.low = 0, .high = 1, .kept_as = "sound"}),
      setting(&Look::show_panels, "panels", "Whether the panels show.", {.kept_as = "panels"}),
      setting(&Look::show_laboratory, "laboratory", "Whether the pages of the laboratory show, below the viewport.",
              {.kept_as = "laboratory"}),
      setting(&Look::laboratory_height, "laboratory_height",
              "Height of the laboratory as a share of the height between menu and status bar. 0: chosen by its page.",
              {.low = 0, .high = 0.75, .kept_as = "laboratory_height"}),
      setting(&Look::workspace, "workspace", "Panels that show: all, or those to build, to ride or to study curves.",
              {.kept_as = "workspace"}),
      setting(&Look::graph_height, "graph_height",
              "Height of the force graph in Build as a share of the height between menu and status bar. 0: by the "
              "window's size.",
              {.low = 0, .high = 0.5, .kept_as = "graph_height"}),
      setting(&Look::sections_by, "sections_by", "Column that the table of sections is sorted by."),
      setting(&Look::sections_descending, "sections_descending", "Whether its largest values come first.")};
};

}  // namespace coaster::world
