// The font of the panels: Inter if it was embedded at build time, else Dear ImGui's own.
#include <algorithm>
#include <cmath>
#include <span>

#include "ui/widgets/imgui_compat.h"
#include "ui/widgets/theme.h"

#ifdef COASTER_HAS_INTER_FONT
namespace coaster::embedded {
extern const unsigned char inter_font[];
extern const std::size_t inter_font_size;
}  // namespace coaster::embedded
#endif

namespace coaster::ui {
namespace {

// Latin, Greek, punctuation, super- and subscripts, arrows, operators: what formulas and names need.
const ImWchar kRanges[] = {0x0020, 0x017F, 0x0370, 0x03FF, 0x2010, 0x2027, 0x2030, 0x203A, 0x2070,
                           0x209F, 0x2190, 0x2199, 0x2200, 0x2265, 0x25A0, 0x25CF, 0};

ImFont* add_font(ImFontAtlas& atlas, float pixels, const ImWchar* ranges = kRanges) {
  const std::span<const unsigned char> inter = inter_font();
  if (!inter.empty()) {
    ImFontConfig config;
    config.FontDataOwnedByAtlas = false;
    config.OversampleH = pixels < 40 ? 3 : 1;  // large letters need no finer steps, but much memory
    config.OversampleV = 1;
    config.PixelSnapH = false;
    config.RasterizerMultiply = 1.1f;  // light text on dark looks thin otherwise
    // The atlas only reads data it does not own.
    ImFont* font = atlas.AddFontFromMemoryTTF(const_cast<unsigned char*>(inter.data()), static_cast<int>(inter.size()),
                                              pixels, &config, ranges);
    if (font != nullptr) return font;
  }
  ImFontConfig config;
  config.SizePixels = std::max(13.0f, pixels);
  return atlas.AddFontDefault(&config);
}

}  // namespace

std::span<const unsigned char> inter_font() {
#ifdef COASTER_HAS_INTER_FONT
  return {embedded::inter_font, embedded::inter_font_size};
#else
  return {};
#endif
}

void load_fonts(float scale) {
  ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
  begin_fonts(atlas);
  atlas.Flags |= ImFontAtlasFlags_NoMouseCursors;
  add_font(atlas, std::round(kFontPixels * scale));
  add_font(atlas, std::max(13.0f, std::round(kSmallFontPixels * scale)));
  static constexpr ImWchar kAscii[] = {0x0020, 0x007E, 0};
  add_font(atlas, std::round(kTitleFontPixels * scale), kAscii);
  finish_fonts(atlas);
}

ImFont* small_font() { return ImGui::GetIO().Fonts->Fonts[1]; }
float small_pixels() { return pixels_of(*small_font()); }
ImFont* title_font() { return ImGui::GetIO().Fonts->Fonts[2]; }

}  // namespace coaster::ui
