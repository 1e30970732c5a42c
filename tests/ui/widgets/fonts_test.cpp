#include <gtest/gtest.h>
#include <imgui.h>

#include "ui/widgets/theme.h"

namespace coaster::ui {
namespace fonts_test {

TEST(fonts, figures_all_have_one_width_at_every_scale) {
  ImGuiContext* context = ImGui::CreateContext();
  ImGui::SetCurrentContext(context);
  for (const float scale : {0.8f, 1.0f, 1.5f, 3.0f}) {
    load_fonts(scale);
    const ImFont& font = *ImGui::GetIO().Fonts->Fonts[0];
    for (ImWchar c = '1'; c <= '9'; ++c) EXPECT_EQ(font.GetCharAdvance(c), font.GetCharAdvance('0')) << scale;
    EXPECT_GT(font.GetCharAdvance('0'), 4 * scale);
  }
  ImGui::DestroyContext(context);
}

TEST(fonts, formulas_have_their_signs) {
  if (inter_font().empty()) GTEST_SKIP() << "built without Inter: the built-in font has Latin alone";
  ImGuiContext* context = ImGui::CreateContext();
  ImGui::SetCurrentContext(context);
  load_fonts(1);
  const ImFont& font = *ImGui::GetIO().Fonts->Fonts[0];
  for (const ImWchar c : {ImWchar(0xB0), ImWchar(0xB2), ImWchar(0xB3), ImWchar(0xD7), ImWchar(0x2026), ImWchar(0x25CF)})
    EXPECT_NE(font.FindGlyphNoFallback(c), nullptr) << c;
  ImGui::DestroyContext(context);
}

}  // namespace fonts_test
}  // namespace coaster::ui
