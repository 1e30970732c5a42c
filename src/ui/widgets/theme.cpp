// Colours and spacing, and the font of the panels: Inter if it was embedded at build time, else Dear ImGui's own.
#include "ui/widgets/theme.h"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>

#include "base/files.h"
#include "platform/system.h"
#include "ui/widgets/imgui_compat.h"
#include "world/appearance_settings.h"

#ifdef COASTER_HAS_INTER_FONT
namespace coaster::embedded {
extern const unsigned char inter_font[];
extern const std::size_t inter_font_size;
}  // namespace coaster::embedded
#endif

namespace coaster::ui {

ImVec4 colour(std::uint32_t rgb, float alpha) {
  const auto channel = [&](int shift) { return static_cast<float>((rgb >> shift) & 0xffu) / 255.0f; };
  return {channel(16), channel(8), channel(0), alpha};
}

ImU32 packed(std::uint32_t rgb, float alpha) { return ImGui::ColorConvertFloat4ToU32(colour(rgb, alpha)); }

namespace {

constexpr ThemeColours kLight{.background = 0xF3F4F6,
                              .raised = 0xE3E6EB,
                              .field = 0xFFFFFF,
                              .border = 0xBCC3CE,
                              .text = 0x1B1F27,
                              .dim = 0x566072,
                              .accent = 0x1F6FD6,
                              .warning = 0xB26A00,
                              .error = 0xC0322B,
                              .good = 0x2A7F4F,
                              .axis = {0xC0322B, 0x2A7F4F, 0x1F6FD6},
                              .plot = 0xFCFCFD,
                              .light = true};
// Contrast of text 21 : 1, of other marks at least 7 : 1 (WCAG 2.1, level AAA). Edges are drawn.
constexpr ThemeColours kHighContrast{.background = 0x000000,
                                     .raised = 0x101010,
                                     .field = 0x1E1E1E,
                                     .border = 0xC8C8C8,
                                     .text = 0xFFFFFF,
                                     .dim = 0xE0E0E0,
                                     .accent = 0xFFD400,
                                     .warning = 0xFFB000,
                                     .error = 0xFF9090,
                                     .good = 0x6CF09A,
                                     .axis = {0xFF9090, 0x6CF09A, 0x82C4FF},
                                     .plot = 0x000000};

// Returns the relative luminance, by the weights of WCAG 2.1 with gamma 2.2 for the curve of sRGB: 0 black, 1 white.
float luminance(std::uint32_t rgb) {
  const auto linear = [&](int shift) { return std::pow(static_cast<float>((rgb >> shift) & 0xffu) / 255.0f, 2.2f); };
  return 0.2126f * linear(16) + 0.7152f * linear(8) + 0.0722f * linear(0);
}

void set_colours(const ThemeColours& p, ImVec4* c) {
  c[ImGuiCol_Text] = colour(p.text);
  c[ImGuiCol_TextDisabled] = colour(p.dim);
  c[ImGuiCol_WindowBg] = colour(p.background);
  c[ImGuiCol_ChildBg] = colour(p.background, 0.0f);
  c[ImGuiCol_PopupBg] = colour(p.raised);
  c[ImGuiCol_Border] = colour(p.border);
  c[ImGuiCol_FrameBg] = colour(p.field);
  c[ImGuiCol_FrameBgHovered] = colour(p.border);
  c[ImGuiCol_FrameBgActive] = colour(p.accent, 0.35f);
  c[ImGuiCol_MenuBarBg] = colour(p.raised);
  c[ImGuiCol_ScrollbarBg] = colour(p.background, 0.0f);
  c[ImGuiCol_ScrollbarGrab] = colour(p.border);
  c[ImGuiCol_ScrollbarGrabHovered] = colour(p.dim, 0.7f);
  c[ImGuiCol_ScrollbarGrabActive] = colour(p.dim);
  c[ImGuiCol_CheckMark] = colour(p.accent);
  c[ImGuiCol_SliderGrab] = colour(p.accent);
  c[ImGuiCol_SliderGrabActive] = colour(p.text);
  c[ImGuiCol_Button] = colour(p.field);
  c[ImGuiCol_ButtonHovered] = colour(p.border);
  c[ImGuiCol_ButtonActive] = colour(p.accent, 0.6f);
  c[ImGuiCol_Header] = colour(p.raised);
  c[ImGuiCol_HeaderHovered] = colour(p.field);
  c[ImGuiCol_HeaderActive] = colour(p.accent, 0.5f);
  c[ImGuiCol_Separator] = colour(p.border);
  c[ImGuiCol_TextSelectedBg] = colour(p.accent, 0.45f);
  c[ImGuiCol_NavHighlight] = colour(p.accent, 0.0f);
  c[ImGuiCol_ModalWindowDimBg] = ImVec4(0, 0, 0, p.light ? 0.30f : 0.55f);
  if (!p.light) return;
  c[ImGuiCol_FrameBgHovered] = colour(p.raised);
  c[ImGuiCol_Button] = colour(0xD3D8E0);
  c[ImGuiCol_HeaderHovered] = colour(0xD3D8E0);
  c[ImGuiCol_SliderGrabActive] = colour(0x174F99);
}

// Latin, Greek, punctuation, super- and subscripts, arrows, operators: what formulas and names need.
const ImWchar kRanges[] = {0x0020, 0x017F, 0x0370, 0x03FF, 0x2010, 0x2027, 0x2030, 0x203A, 0x2070,
                           0x209F, 0x2190, 0x2199, 0x2200, 0x2265, 0x25A0, 0x25CF, 0};
const ImWchar kTitleRanges[] = {0x0020, 0x007E, kBox, kBox, 0};
constexpr std::size_t kMostBlocks = 1024;

// True if a file has outlines that Dear ImGui reads.
bool has_outlines(std::string_view file, int index) {
  const auto number = [&](std::size_t at, std::size_t bytes) {
    std::size_t value = 0;
    for (; bytes-- > 0; ++at) value = value << 8 | (at < file.size() ? static_cast<unsigned char>(file[at]) : 0U);
    return value;
  };
  const std::size_t start = file.starts_with("ttcf") ? number(12 + 4 * static_cast<std::size_t>(index), 4) : 0;
  bool letters = false, outlines = false;
  for (std::size_t i = 0, at = start + 12; i < number(start + 4, 2) && at + 4 <= file.size(); ++i, at += 16) {
    const std::string_view table = file.substr(at, 4);
    letters = letters || table == "cmap";
    outlines = outlines || table == "glyf" || table == "CFF ";
  }
  return letters && outlines;
}

}  // namespace

const ThemeColours& palette_of(world::Theme theme) {
  static constexpr const ThemeColours* kPalettes[] = {&kDark, &kLight, &kHighContrast};
  static_assert(std::size(kPalettes) == base::count_of<world::Theme>());
  return *kPalettes[static_cast<std::size_t>(theme)];
}

const ThemeColours& palette() {
  const void* const chosen = ImGui::GetIO().UserData;
  return chosen != nullptr ? *static_cast<const ThemeColours*>(chosen) : kDark;
}

std::uint32_t ink(std::uint32_t rgb) {
  if (!palette().light) return rgb;
  constexpr float kMost = 0.24f;  // at least 3.5 : 1 on the light backgrounds
  const std::uint32_t r = rgb >> 16 & 0xffu, g = rgb >> 8 & 0xffu, b = rgb & 0xffu;
  const bool grey = std::max({r, g, b}) - std::min({r, g, b}) < 24;
  const float bright = luminance(rgb);
  if (grey && bright > kMost) return bright > 0.6f ? palette().text : palette().dim;
  if (bright <= kMost) return rgb;
  const float factor = std::pow(kMost / bright, 1 / 2.2f);
  const auto darker = [&](std::uint32_t channel) {
    return static_cast<std::uint32_t>(std::lround(static_cast<float>(channel) * factor));
  };
  return darker(r) << 16 | darker(g) << 8 | darker(b);
}

void apply_theme(const ThemeColours& palette, float scale) {
  ImGuiStyle style;
  ImGui::StyleColorsDark(&style);
  set_colours(palette, style.Colors);
  style.WindowPadding = {10, 6};
  style.FramePadding = {8, 3};
  style.ItemSpacing = {8, 5};
  style.ItemInnerSpacing = {6, 4};
  style.WindowRounding = 0;
  style.FrameRounding = style.PopupRounding = style.GrabRounding = style.ScrollbarRounding = 4;
  style.WindowBorderSize = 0;
  style.PopupBorderSize = 1;
  style.ScrollbarSize = 10;
  style.GrabMinSize = 10;
  style.DisabledAlpha = 0.45f;
  style.ScaleAllSizes(scale);
  style.WindowMinSize = {1, 1};  // ImGui accepts no less
  style.FrameBorderSize = palette.light || palette.background == 0 ? std::max(1.0f, std::floor(scale)) : 0.0f;
  ImGui::GetIO().UserData = const_cast<ThemeColours*>(&palette);  // ImGui stores it; nobody writes through it
  ImGui::GetStyle() = style;
}

std::span<const unsigned char> inter_font() {
#ifdef COASTER_HAS_INTER_FONT
  return {embedded::inter_font, embedded::inter_font_size};
#else
  return {};
#endif
}

ImFont* PanelFonts::add_font(float pixels, const ImWchar* base) const {
  ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
  ImFontConfig config;
  config.SizePixels = std::max(13.0f, pixels);
  const std::span<const unsigned char> inter = inter_font();
  if (inter.empty()) return atlas.AddFontDefault(&config);
  config.FontDataOwnedByAtlas = false;
  config.OversampleH = pixels < 40 ? 3 : 1;  // large letters need no finer steps, but much memory
  config.OversampleV = 1;
  config.PixelSnapH = false;
  config.RasterizerMultiply = 1.1f;  // light text on dark looks thin otherwise
  // The atlas only reads data it does not own.
  ImFont* const font = atlas.AddFontFromMemoryTTF(const_cast<unsigned char*>(inter.data()),
                                                  static_cast<int>(inter.size()), pixels, &config, base);
  font->FallbackChar = kBox;
  config.MergeMode = true;
  config.OversampleH = 1;
  if (base == ranges_.data())
    for (const File& file : files_) {
      config.FontNo = file.index;
      atlas.AddFontFromMemoryTTF(const_cast<char*>(file.bytes.data()), static_cast<int>(file.bytes.size()), pixels,
                                 &config, base);
    }
  return font;
}

bool PanelFonts::build() {
  ranges_.assign(std::begin(kRanges), std::end(kRanges) - 1);
  for (const ImWchar block : blocks_) ranges_.insert(ranges_.end(), {block, ImWchar(block + kBlock - 1)});
  ranges_.push_back(0);
  ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
  begin_fonts(atlas);
  atlas.Flags |= ImFontAtlasFlags_NoMouseCursors;
  add_font(std::round(kFontPixels * scale_), ranges_.data());
  add_font(std::max(13.0f, std::round(kSmallFontPixels * scale_)), ranges_.data());
  add_font(std::round(kTitleFontPixels * scale_), kTitleRanges);
  return finish_fonts(atlas, blocks_);
}

// Adds files of the system for letters that the fonts lack. Returns true if it found any.
bool PanelFonts::add_files(const std::set<ImWchar>& blocks) {
  std::vector<unsigned> lacking;
  for (const ImWchar block : blocks)
    for (int c = block; c < block + kBlock; ++c) {
      const bool is_private = c >= 0xE000 && c <= 0xF8FF;  // of fonts of pictures, which Dear ImGui does not read
      if (!is_private && !has_glyph(*ImGui::GetIO().Fonts->Fonts[0], static_cast<ImWchar>(c)))
        lacking.push_back(static_cast<unsigned>(c));
    }
  const std::size_t before = files_.size();
  for (const platform::SystemFont& font : platform::fonts_with(std::move(lacking))) {
    if (std::ranges::find(files_, font.path, &File::path) != files_.end()) continue;
    base::Result<std::string> bytes = base::Files().read(font.path);
    if (bytes && has_outlines(*bytes, font.index)) files_.push_back({font.path, std::move(*bytes), font.index});
  }
  return files_.size() > before;
}

bool PanelFonts::load(float scale) {
  std::set<ImWchar> blocks;
  take_missing(blocks);
  std::erase_if(blocks, [&](ImWchar block) { return blocks_.contains(block); });
  if (blocks_.size() > kMostBlocks) blocks_.clear();
  for (const ImWchar block : blocks) {
    // Inter's alphabets come as a whole: the next word has other letters of them.
    const bool is_of_inter = block < 0x500 || (block >= 0x1E00 && block < 0x2000);
    const unsigned page = is_of_inter ? 256 : kBlock, first = block / page * page;
    for (unsigned i = first; i < first + page; i += kBlock) blocks_.insert(static_cast<ImWchar>(i));
  }
  if (scale == std::exchange(scale_, scale) && blocks.empty()) return false;
  build();
  if (!inter_font().empty() && add_files(blocks) && !build()) files_.clear(), build();
  return true;
}

void load_fonts(float scale) { PanelFonts().load(scale); }

ImFont* small_font() { return ImGui::GetIO().Fonts->Fonts[1]; }
float small_pixels() { return pixels_of(*small_font()); }
ImFont* title_font() { return ImGui::GetIO().Fonts->Fonts[2]; }

}  // namespace coaster::ui
