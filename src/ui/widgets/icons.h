// Icons of simple strokes, drawn in the colour of the text that they stand beside.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include <imgui.h>

#include "world/element.h"

namespace coaster::ui {

struct Ui;

enum class Icon : std::uint8_t {
  play,
  pause,
  step,
  reset,
  straight,
  curve,
  helix,
  climb,
  dive,
  camelback,
  loop,
  corkscrew
};

Icon icon_of(world::ElementKind kind);

// Into the square of `size` px below and right of `low`.
void draw_icon(ImDrawList& list, Icon icon, ImVec2 low, float size, ImU32 colour);

// A button as in widgets.h with an icon before its label, or above it, in the small font. width: px.
bool icon_button(Ui& ui, Icon icon, std::string_view label, std::string_view tooltip, bool enabled, float width,
                 bool above = false);

}  // namespace coaster::ui
