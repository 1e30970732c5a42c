// Colours and spacing.
#include "ui/theme.h"

#include <cmath>

namespace coaster::ui {

ImVec4 colour(std::uint32_t rgb, float alpha) {
  const auto channel = [&](int shift) { return static_cast<float>((rgb >> shift) & 0xffu) / 255.0f; };
  return {channel(16), channel(8), channel(0), alpha};
}

ImU32 packed(std::uint32_t rgb, float alpha) { return ImGui::ColorConvertFloat4ToU32(colour(rgb, alpha)); }

namespace {

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
}

}  // namespace

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
  style.WindowMinSize = {1, 1};  // ImGui refuses less
  ImGui::GetStyle() = style;
}

}  // namespace coaster::ui
