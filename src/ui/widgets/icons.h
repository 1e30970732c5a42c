// Icons of simple strokes, drawn in the colour of the text next to them, and medals, ticks and crosses.
#pragma once

#include <imgui.h>

#include <span>
#include <string_view>

#include "world/element.h"

namespace coaster::ui {

struct WidgetFrame;

// Curves, a filled triangle and filled bars in the unit square, y down.
struct VectorIcon {
  struct Place {
    float x, y;
  };
  struct Stroke {
    Place p0, p1, p2, p3;  // a cubic Bézier curve
  };
  struct Bar {
    Place low, high;
  };
  std::span<const Stroke> strokes;
  std::span<const Place> arrow = {};  // three corners, or none
  std::span<const Bar> bars = {};
};
extern const VectorIcon kPlayIcon, kPauseIcon, kStepIcon, kResetIcon, kPencilIcon, kCircuitIcon, kRecordIcon, kStopIcon;
const VectorIcon& icon_of(world::ElementKind kind);  // one icon for all force elements

// Position of a button's icon: before its label, above it with the label in the small font, or without a visible label.
enum class IconPlace { before, above, alone };
// Shows a button as in widgets.h with an icon. width: px; height: 34 design px alone, 36 above the label.
bool icon_button(WidgetFrame& ui, const VectorIcon& icon, std::string_view label, std::string_view tooltip,
                 bool enabled, float width, IconPlace place = IconPlace::before);

// Draws a medal on its ribbon within a square of `size` px at `low`: 1 bronze, 2 silver, 3 gold. A medal not earned is
// an outline.
void draw_medal(ImDrawList& list, ImVec2 low, float size, int medal, bool earned);
// Draws a tick in a filled disc, or a cross in a ring, within a square of `size` px.
void draw_mark(ImDrawList& list, ImVec2 low, float size, bool good);

std::string_view medal_title(int medal);  // returns "Gold"; "No medal" for 0

}  // namespace coaster::ui
