#include <gtest/gtest.h>
#include <imgui.h>

#include <map>

#include "ui/widgets/imgui_compat.h"
#include "ui/widgets/theme.h"

namespace coaster::ui {
namespace fonts_test {

struct FontsTest : testing::Test {
  FontsTest() {
    ImGui::SetCurrentContext(context);
    set_up_context();
    ImGui::GetIO().IniFilename = nullptr;  // it would write one
    ImGui::GetIO().DisplaySize = {2000, 2000};
  }
  ~FontsTest() override { ImGui::DestroyContext(context); }

  static float width_of(const char* text) {
    ImFont& font = *ImGui::GetIO().Fonts->Fonts[0];
    return font.CalcTextSizeA(pixels_of(font), 1e9f, 0, text).x;
  }

  ImGuiContext* context = ImGui::CreateContext();
  std::map<std::uintptr_t, int> heights;  // of textures, by their names
};

TEST_F(FontsTest, figures_all_have_one_width_at_every_scale) {
  for (const float scale : {0.8f, 1.0f, 1.5f, 3.0f}) {
    load_fonts(scale);
    const float zeros = width_of("00000000");
    for (const char* text :
         {"11111111", "22222222", "33333333", "44444444", "55555555", "66666666", "77777777", "88888888", "99999999"})
      EXPECT_NEAR(width_of(text), zeros, 1e-3f) << text << " at " << scale;
    EXPECT_GT(zeros, 8 * 4 * scale);
  }
}

TEST_F(FontsTest, text_is_rasterised_in_the_size_it_is_drawn_in_at_every_scale) {
  for (const float scale : {0.8f, 1.0f, 1.37f, 2.6f}) {
    load_fonts(scale);
    ImGui::NewFrame();
    EXPECT_EQ(ImGui::GetFontSize(), pixels_of(*ImGui::GetFont())) << scale;
    ImDrawList& list = *ImGui::GetForegroundDrawList();
    ImFont* const fonts[] = {ImGui::GetFont(), small_font(), title_font()};
    float y = 0;
    for (ImFont* const font : fonts)
      list.AddText(font, pixels_of(*font), {5, y += 200}, 0xffffffffu, "Red Comet: 29 knots");
    ImGui::Render();
    upload_textures([&](std::uintptr_t id, int, int height, const void*) { heights[id] = height; });
    unsigned glyphs = 0;
    for (const ImDrawCmd& command : list.CmdBuffer) {
      const auto height = static_cast<float>(heights[texture_of(command)]);
      for (unsigned i = command.IdxOffset; i < command.IdxOffset + command.ElemCount; i += 6, ++glyphs) {
        const ImDrawIdx first = list.IdxBuffer[static_cast<int>(i)];  // of a glyph's rectangle: 0 1 2, 0 2 3
        const ImDrawVert &low = list.VtxBuffer[first], &high = list.VtxBuffer[first + 2];
        EXPECT_NEAR((high.uv.y - low.uv.y) * height, high.pos.y - low.pos.y, 0.02f) << scale;
      }
    }
    EXPECT_EQ(glyphs, 3 * (sizeof("Red Comet: 29 knots") - 1 - 3)) << "all but the blanks";
  }
}

TEST_F(FontsTest, formulas_have_their_signs) {
  if (inter_font().empty()) GTEST_SKIP() << "built without Inter: the built-in font has Latin alone";
  load_fonts(1);
  ImFont& font = *ImGui::GetIO().Fonts->Fonts[0];
  for (const ImWchar c : {ImWchar(0xB0), ImWchar(0xB2), ImWchar(0xB3), ImWchar(0xD7), ImWchar(0x2026), ImWchar(0x25CF)})
    EXPECT_TRUE(has_glyph(font, c)) << c;
  EXPECT_FALSE(has_glyph(font, ImWchar(0x4E00))) << "Inter has no Chinese";
}

}  // namespace fonts_test
}  // namespace coaster::ui
