// Colours, spacing and fonts of the panels, with the letters that texts need. A theme is a set of named colours.
#pragma once

#include <imgui.h>

#include <cstdint>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "world/settings.h"

namespace coaster::ui {

// Colours as 0xRRGGBB.
struct ThemeColours {
  std::uint32_t background = 0x1B1F27, raised = 0x262C37, field = 0x343D4D, border = 0x3A4352;
  std::uint32_t text = 0xE6E9EF, dim = 0x9AA3B2;
  std::uint32_t accent = 0x4C9AFF, warning = 0xF2B84B, error = 0xE5534B, good = 0x4FB477;
  std::uint32_t axis[3] = {0xE5534B, 0x4FB477, 0x4C9AFF};
  std::uint32_t plot = 0x171B22;  // background of plots
  bool light = false;             // dark text on a light background
};
inline constexpr ThemeColours kDark{};
const ThemeColours& palette_of(world::Theme theme);
// Returns the palette of the current ImGui context, after apply_theme().
const ThemeColours& palette();

// Returns a data colour, chosen for dark backgrounds, adapted to the contrast of the current theme. The hue is
// unchanged.
std::uint32_t ink(std::uint32_t rgb);

ImVec4 colour(std::uint32_t rgb, float alpha = 1.0f);
ImU32 packed(std::uint32_t rgb, float alpha = 1.0f);

inline constexpr float kFontPixels = 17.0f;       // line height at scale 1: Inter's em is then 14 px
inline constexpr float kSmallFontPixels = 14.0f;  // ticks and read-outs of plots, notes
inline constexpr float kTitleFontPixels = 36.0f;  // for headings of whole pages; ASCII only

// Sets colours and sizes of the current ImGui context for `scale`; the palette must outlive it.
void apply_theme(const ThemeColours& palette, float scale);

// Returns the Inter font, embedded at build time; empty if the build did not find it.
std::span<const unsigned char> inter_font();

// Replaces the fonts of the current context with Inter (or the built-in font if Inter was not embedded) at `scale`. All
// digits get the width of the widest, so that changing numbers do not move. Call outside a frame.
void load_fonts(float scale);
ImFont* title_font();
ImFont* small_font();  // font of the current context, after load_fonts()
float small_pixels();  // line height of the small font, px

// The panels' fonts, with the letters that texts need.
class PanelFonts {
 public:
  // Loads the fonts of the current context if `scale` changed or the last frame showed letters for the first time:
  // those of Inter, else of the system's fonts, else a box for each. Returns true if it did. Call outside a frame.
  bool load(float scale);
  float scale() const { return scale_; }  // of the last load()

 private:
  struct File {
    std::string path, bytes;
    int index = 0;
  };
  bool build();
  ImFont* add_font(float pixels, const ImWchar* base) const;
  bool add_files(const std::set<ImWchar>& blocks);

  float scale_ = 0;
  std::set<ImWchar> blocks_;  // of letters, by the first one (imgui_compat.h)
  std::vector<File> files_;
  std::vector<ImWchar> ranges_;  // of Inter's and the files' letters; the fonts refer to it
};

}  // namespace coaster::ui
