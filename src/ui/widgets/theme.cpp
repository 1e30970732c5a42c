// Colours and spacing.
#include "ui/widgets/theme.h"
#include "world/look.h"

#include <algorithm>
#include <cmath>

namespace coaster::ui {

ImVec4 colour(std::uint32_t rgb, float alpha) {
  const auto channel = [&](int shift) { return static_cast<float>((rgb >> shift) & 0xffu) / 255.0f; };
  return {channel(16), channel(8), channel(0), alpha};
}

ImU32 packed(std::uint32_t rgb, float alpha) { return ImGui::ColorConvertFloat4ToU32(colour(rgb, alpha)); }

namespace {

constexpr Palette kLight{.background = 0xF3F4F6,
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
constexpr Palette kHighContrast{.background = 0x000000,
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

void set_colours(const Palette& p, ImVec4* c) {
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

}  // namespace

const Palette& palette_of(world::Theme theme) {
  static constexpr const Palette* kPalettes[] = {&kDark, &kLight, &kHighContrast};
  static_assert(std::size(kPalettes) == base::count_of<world::Theme>());
  return *kPalettes[static_cast<std::size_t>(theme)];
}

const Palette& palette() {
  const void* const chosen = ImGui::GetIO().UserData;
  return chosen != nullptr ? *static_cast<const Palette*>(chosen) : kDark;
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

void apply_theme(const Palette& palette, float scale) {
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
  ImGui::GetIO().UserData = const_cast<Palette*>(&palette);  // ImGui stores it; nobody writes through it
  ImGui::GetStyle() = style;
}

}  // namespace coaster::ui
