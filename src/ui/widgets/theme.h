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
  std::uint32_t plot = 0x171B22;  // background of plots
  bool light = false;             // dark text on a light background
};
inline constexpr Palette kDark{};
const Palette& palette_of(world::Theme theme);
// Returns the palette of the current ImGui context, after apply_theme().
const Palette& palette();

// Returns a data colour, chosen for dark backgrounds, adapted to the contrast of the current theme. The hue is
// unchanged.
std::uint32_t ink(std::uint32_t rgb);

ImVec4 colour(std::uint32_t rgb, float alpha = 1.0f);
ImU32 packed(std::uint32_t rgb, float alpha = 1.0f);

inline constexpr float kFontPixels = 17.0f;       // line height at scale 1: Inter's em is then 14 px
inline constexpr float kSmallFontPixels = 14.0f;  // ticks and read-outs of plots, notes
inline constexpr float kTitleFontPixels = 36.0f;  // for headings of whole pages; ASCII only

// Sets colours and sizes of the current ImGui context for `scale`; the palette must outlive it.
void apply_theme(const Palette& palette, float scale);

// Returns the Inter font, embedded at build time; empty if the build did not find it.
std::span<const unsigned char> inter_font();

// Replaces the fonts of the current context with Inter (or the built-in font if Inter was not embedded) at `scale`. All
// digits get the width of the widest, so that changing numbers do not move. Call outside a frame.
void load_fonts(float scale);
ImFont* title_font();
ImFont* small_font();  // font of the current context, after load_fonts()
float small_pixels();  // line height of the small font, px

}  // namespace coaster::ui
