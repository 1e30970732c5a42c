// Colours, spacing and fonts of the panels. A theme is a set of named colours.
#pragma once

#include <cstdint>
#include <span>

#include <imgui.h>

#include "world/settings.h"

namespace coaster::ui {

// Colours as 0xRRGGBB.
struct Palette {
  std::uint32_t background = 0x1B1F27, raised = 0x262C37, field = 0x343D4D, border = 0x3A4352;
  std::uint32_t text = 0xE6E9EF, dim = 0x9AA3B2;
  std::uint32_t accent = 0x4C9AFF, warning = 0xF2B84B, error = 0xE5534B, good = 0x4FB477;
  std::uint32_t axis[3] = {0xE5534B, 0x4FB477, 0x4C9AFF};
  std::uint32_t plot = 0x171B22;  // ground of plots
  bool light = false;             // dark on light
};
inline constexpr Palette kDark{};
const Palette& palette_of(world::Theme theme);
// Of the current ImGui context, after apply_theme().
const Palette& palette();

// Returns a data colour, chosen for dark backgrounds, adapted to the contrast of the current theme. Same hue.
std::uint32_t ink(std::uint32_t rgb);

ImVec4 colour(std::uint32_t rgb, float alpha = 1.0f);
ImU32 packed(std::uint32_t rgb, float alpha = 1.0f);

inline constexpr float kFontPixels = 17.0f;       // line height at scale 1: Inter's em is then 14 px
inline constexpr float kSmallFontPixels = 14.0f;  // ticks and read-outs of plots, notes
inline constexpr float kTitleFontPixels = 36.0f;  // of whole pages; ASCII alone

// Colours and sizes of the current ImGui context for `scale`; the palette must outlive it.
void apply_theme(const Palette& palette, float scale);

// The bytes of the Inter font, embedded at build; empty when the build found no such font.
std::span<const unsigned char> inter_font();

// Replaces the fonts of the current context by Inter (or the built-in font where Inter was not embedded) at `scale`.
// Digits all get the width of the widest, so that numbers stand still. Call outside a frame.
void load_fonts(float scale);
ImFont* title_font();
ImFont* small_font();  // of the current context, after load_fonts()
float small_pixels();  // height of its lines, px

}  // namespace coaster::ui
