// The fonts of the panels (ui/widgets/theme.h).
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

  // Loads letters as two frames that show a text do; returns whether they were new.
  static bool show(PanelFonts& letters, const char* text) {
    ImGui::NewFrame();
    ImGui::GetForegroundDrawList()->AddText({5, 5}, 0xffffffffu, text);
    ImGui::Render();
    upload_textures([](std::uintptr_t, int, int, const void*) {});
    return letters.load(1);
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

TEST_F(FontsTest, letters_of_other_alphabets_are_loaded_when_a_text_shows_them) {
  if (inter_font().empty()) GTEST_SKIP() << "built without Inter";
  PanelFonts letters;
  EXPECT_TRUE(letters.load(1));
  EXPECT_FALSE(letters.load(1));
  show(letters, "\u0420\u0443\u0441\u0441\u043a\u0438\u0439 \u1f08 \u1ea1");  // Cyrillic, Greek, Vietnamese
  ImFont& font = *ImGui::GetIO().Fonts->Fonts[0];
  for (const ImWchar c : {ImWchar(0x0420), ImWchar(0x0439), ImWchar(0x0434), ImWchar(0x1F08), ImWchar(0x1EA1)})
    EXPECT_TRUE(has_glyph(font, c)) << c;
  EXPECT_FALSE(show(letters, "\u0420\u0443\u0441\u0441\u043a\u0438\u0439")) << "loaded once";
  EXPECT_GT(width_of("\u0429"), 1.2f * width_of("\u0413")) << "a wide and a narrow letter: no boxes";
}

TEST_F(FontsTest, letters_that_no_font_has_are_one_box_each) {
  if (inter_font().empty()) GTEST_SKIP() << "built without Inter";
  PanelFonts letters;
  letters.load(1);
  const float box = width_of("\u25a1");
  show(letters, "\uf8f0\uf8f4\uf8ff");  // for private use
  EXPECT_NEAR(width_of("\uf8f0\uf8f4\uf8ff"), 3 * box, 1e-3f);
  EXPECT_FALSE(show(letters, "\uf8f0\uf8f4\uf8ff")) << "asked for once";
  ImGui::NewFrame();
  const ImDrawList& list = *ImGui::GetForegroundDrawList();
  ImGui::GetForegroundDrawList()->AddText({5, 5}, 0xffffffffu, "\uf8f0\u25a1");
  ASSERT_EQ(list.VtxBuffer.Size, 8);
  EXPECT_EQ(list.VtxBuffer[0].uv.x, list.VtxBuffer[4].uv.x) << "the picture of a box";
  ImGui::Render();
}

}  // namespace fonts_test
}  // namespace coaster::ui
