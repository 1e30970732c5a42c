// Settings of appearance and sound.
#pragma once

#include <cstdint>
#include <span>

#include "base/enum_names.h"
#include "base/units.h"
#include "world/setting_row.h"

namespace coaster::world {

// Colours of the panels, by name in scripts and in the settings file.
enum class Theme : std::uint8_t { dark, light, high_contrast };
inline constexpr base::NameRow kThemes[] = {{"dark", "Dark", "Colours of the panels."},
                                            {"light", "Light", "Colours of the panels."},
                                            {"high_contrast", "High contrast", "Colours of the panels."}};
constexpr std::span<const base::NameRow> rows_of(Theme) { return kThemes; }

// Light, sky and ground of the scene, by name in scripts and in the settings file.
enum class Style : std::uint8_t { day, dusk, night, blueprint };
inline constexpr base::NameRow kStyles[] = {
    {"day", "Day", "High sun, clear sky."},
    {"dusk", "Dusk", "Low sun, long shadows."},
    {"night", "Night", "Moonlight, stars and lamps."},
    {"blueprint", "Blueprint", "Lines on blue, for the laboratory and for print."}};
constexpr std::span<const base::NameRow> rows_of(Style) { return kStyles; }

// How much of the surroundings is drawn. The document decides where land is, this what grows and glitters on it.
enum class Scenery : std::uint8_t { plain, park, rich };
inline constexpr base::NameRow kSceneries[] = {
    {"plain", "Plain", "Land and flat water, no trees: for measuring and for print."},
    {"park", "Park", "Trees, water, and soft light from all sides."},
    {"rich", "Rich", "The same with more trees and grass near the eye, for fast graphics cards."}};
constexpr std::span<const base::NameRow> rows_of(Scenery) { return kSceneries; }

struct Appearance {
  float ui_scale = 1;
  Theme theme = Theme::dark;
  Style style = Style::day;
  Scenery scenery = Scenery::plain;
  base::UnitSystem units = base::UnitSystem::m_s;
  bool shadows = true;
  float sound = 0.5f;
  friend bool operator==(const Appearance&, const Appearance&) = default;

  static constexpr auto kRows = std::tuple{
      setting(&Appearance::ui_scale, "scale", "Scale of the panels.", {.low = 0.75, .high = 3, .kept_as = "ui_scale"}),
      setting(&Appearance::theme, "theme", "Colours of the panels.", {.kept_as = "theme"}),
      setting(&Appearance::style, "style", "Light of the scene.", {.kept_as = "style"}),
      setting(&Appearance::scenery, "scenery", "How much of the surroundings is drawn.",
              {.kept_as = "scenery", .for_user = static_cast<int>(Scenery::park)}),
      setting(&Appearance::units, "units", "Units that lengths and speeds are shown and typed in. Scripts stay metric.",
              {.kept_as = "units"}),
      setting(&Appearance::shadows, "shadows", "Whether track and trains cast shadows. Frames cost less without them.",
              {.kept_as = "shadows"}),
      setting(&Appearance::sound, "sound", "Ride volume. 0 mutes it.", {.low = 0, .high = 1, .kept_as = "sound"})};
};

}  // namespace coaster::world
