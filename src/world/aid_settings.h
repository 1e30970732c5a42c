// Settings of aids for building and riding: hints, arrows, previews.
#pragma once

#include "world/park.h"
#include "world/setting_row.h"

namespace coaster::world {

// What the mouse does to the ground.
enum class Brush : std::uint8_t { off, raise, smooth, flatten, slope, woods };
inline constexpr base::NameRow kBrushes[] = {
    {"off", "Off", "The mouse selects and moves."},
    {"raise", "Raise", "Raise the ground; with Shift lower it."},
    {"smooth", "Smooth", "Smooth the ground."},
    {"flatten", "Flatten", "Make the ground as high as where the stroke begins."},
    {"slope", "Slope", "Click where it begins and where it ends: one slope between their heights."},
    {"woods", "Woods", "Let trees grow; with Shift clear them, with Ctrl as the land has them."}};
constexpr std::span<const base::NameRow> rows_of(Brush) { return kBrushes; }
inline constexpr double kLeastBrush = 1, kLargestBrush = 200;  // m, radii

struct EditingAids {
  bool show_hints = false;
  bool show_card = false;
  bool show_gizmo = true;
  bool append_mode = false;
  bool show_element = false;
  int circuit = 0;  // the previewed closing section, from 1; 0: none
  Brush brush = Brush::off;
  float brush_radius = 20;      // m
  Land new_land = Land::plain;  // of new tracks
  friend bool operator==(const EditingAids&, const EditingAids&) = default;

  static constexpr auto kRows =
      std::tuple{setting(&EditingAids::show_hints, "hints", "Whether the first steps show in the viewport.",
                         {.kept_as = "hints", .for_user = 1}),
                 setting(&EditingAids::show_card, "card", "Whether the score card shows when a ride ends.",
                         {.kept_as = "card", .for_user = 1}),
                 setting(&EditingAids::show_gizmo, "gizmo", "Whether the selected knots have arrows that move them.",
                         {.kept_as = "gizmo", .for_user = 1}),
                 setting(&EditingAids::append_mode, "append_mode", "Whether a click on the ground appends a knot."),
                 setting(&EditingAids::show_element, "element.preview",
                         "Whether the palette's element is previewed at the open end."),
                 setting(&EditingAids::circuit, "complete.choose",
                         "Closing section that is previewed, from 1; complete takes the same numbers. 0: none.",
                         {.low = 0, .high = 3}),
                 setting(&EditingAids::brush, "brush", "What the mouse does to the ground of a park."),
                 setting(&EditingAids::brush_radius, "brush.radius", "Radius of the brush.",
                         {.low = kLeastBrush, .high = kLargestBrush, .unit = "m"}),
                 setting(&EditingAids::new_land, "new_land", "The land of tracks begun in a window; plain: no park.",
                         {.kept_as = "new_land", .for_user = static_cast<int>(Land::hills)})};
};

}  // namespace coaster::world
