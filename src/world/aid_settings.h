// Settings of aids for building and riding: hints, arrows, previews.
#pragma once

#include "world/setting_row.h"

namespace coaster::world {

struct EditingAids {
  bool show_hints = false;
  bool show_card = false;
  bool show_gizmo = true;
  bool append_mode = false;
  bool show_element = false;
  int circuit = 0;  // the previewed closing section, from 1; 0: none
  friend bool operator==(const EditingAids&, const EditingAids&) = default;

  static constexpr auto kRows =
      std::tuple{setting(&EditingAids::show_hints, "hints", "Whether the first steps show in the viewport.",
                         {.kept_as = "hints", .on_for_user = true}),
                 setting(&EditingAids::show_card, "card", "Whether the score card shows when a ride ends.",
                         {.kept_as = "card", .on_for_user = true}),
                 setting(&EditingAids::show_gizmo, "gizmo", "Whether the selected knots have arrows that move them.",
                         {.kept_as = "gizmo", .on_for_user = true}),
                 setting(&EditingAids::append_mode, "append_mode", "Whether a click on the ground appends a knot."),
                 setting(&EditingAids::show_element, "element.preview",
                         "Whether the palette's element is previewed at the open end."),
                 setting(&EditingAids::circuit, "complete.choose",
                         "Closing section that is previewed, from 1; complete takes the same numbers. 0: none.",
                         {.low = 0, .high = 3})};
};

}  // namespace coaster::world
