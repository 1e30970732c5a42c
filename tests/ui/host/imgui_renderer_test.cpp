// Part: src/ui/host/imgui_backend.
#include "ui/host/imgui_backend.h"

#include "edit/commands/commands_session.h"
#include "edit/commands/set_setting.h"
#include "gfx/image.h"
#include "ui/stage.h"
#include "ui/widgets/theme.h"
#include "world/laboratory_settings.h"
#include "world/panel_settings.h"

namespace coaster::ui {
namespace imgui_renderer_test {

struct ImGuiRendererTest : Stage {
  // The picture after clearing to `clear` and drawing the UI, rows from the bottom.
  std::vector<std::uint8_t> picture(float clear) {
    GLuint texture = 0, target = 0;
    gl_.GenTextures(1, &texture);
    gl_.BindTexture(GL_TEXTURE_2D, texture);
    gl_.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, width_, height_, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    gl_.GenFramebuffers(1, &target);
    gl_.BindFramebuffer(GL_FRAMEBUFFER, target);
    gl_.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture, 0);
    gl_.ClearColor(clear, clear, clear, 1);
    gl_.Clear(GL_COLOR_BUFFER_BIT);
    host_->draw(width_, height_);
    std::vector<std::uint8_t> pixels(static_cast<std::size_t>(width_ * height_ * 4));
    gl_.ReadPixels(0, 0, width_, height_, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
    EXPECT_EQ(gl_.GetError(), static_cast<GLenum>(GL_NO_ERROR));
    gl_.BindFramebuffer(GL_FRAMEBUFFER, 0);
    gl_.DeleteFramebuffers(1, &target);
    gl_.DeleteTextures(1, &texture);
    return pixels;
  }
  std::uint32_t at(const std::vector<std::uint8_t>& pixels, int x, int y) const {
    const std::size_t i = 4 * static_cast<std::size_t>((height_ - 1 - y) * width_ + x);
    return static_cast<std::uint32_t>(pixels[i] << 16 | pixels[i + 1] << 8 | pixels[i + 2]);
  }
};

TEST_F(ImGuiRendererTest, panels_have_the_themes_colours_and_the_viewport_is_left_alone) {
  frames(3);
  const auto pixels = picture(0.2f);
  const view::Viewport& scene = host_->view().viewport;
  EXPECT_EQ(at(pixels, 2, 400), kDark.background);
  EXPECT_EQ(at(pixels, static_cast<int>(scene.x + 20), static_cast<int>(scene.y + 20)), 0x333333u);
  EXPECT_EQ(at(pixels, 700, 5), kDark.raised);  // the menu bar beside its titles
}

TEST_F(ImGuiRendererTest, text_is_drawn_bright_on_dark) {
  frames(3);
  const auto pixels = picture(0);
  const Widget& w = *find("Evaluation/Show polyline");
  int bright = 0;
  for (int y = static_cast<int>(w.y); y < static_cast<int>(w.y + w.height); ++y)
    for (int x = static_cast<int>(w.x + w.height + 4); x < static_cast<int>(w.x + w.width); ++x)
      bright += (at(pixels, x, y) & 0xff) > 0xb0;
  EXPECT_GT(bright, 60);
}

// Eight plots of a whole ride have more vertices than indices of 16 bits can name.
TEST_F(ImGuiRendererTest, a_window_of_many_vertices_is_drawn_to_the_last_one) {
  ASSERT_TRUE(edit::apply(session_, files_, edit::LoadTrack{COASTER_SOURCE_DIR "/tracks/loop.json"}).ok());
  ASSERT_TRUE(edit::apply(session_, files_, edit::Set<&world::Panels::show_laboratory>{true}).ok());
  ASSERT_TRUE(edit::apply(session_, files_, edit::Set<&world::Panels::laboratory_height>{0.75f}).ok());
  ASSERT_TRUE(edit::apply(session_, files_, edit::Set<&world::LabView::page>{world::LabPage::riders}).ok());
  resize(1920, 1080);
  frames(2);
  const auto pixels = picture(0);
  const Widget* const last = find("Laboratory/Height plot");
  ASSERT_TRUE(last != nullptr && last->visible);
  int of_curve = 0;
  for (int y = static_cast<int>(last->y); y < static_cast<int>(last->y + last->height); ++y)
    for (int x = static_cast<int>(last->x); x < static_cast<int>(last->x + last->width); ++x)
      of_curve += at(pixels, x, y) >> 16 > 0xb0;
  EXPECT_GT(of_curve, 300);
}

// Their textures are the program's, in addition to those of fonts.
TEST_F(ImGuiRendererTest, the_start_screen_shows_pictures_of_tracks) {
  host_->show_start();
  frame();
  ASSERT_FALSE(last_.wanted_pictures.empty());
  gfx::Image image{16, 9, {}};
  for (int i = 0; i < 16 * 9; ++i) image.rgba.insert(image.rgba.end(), {0xd0, 0x20, 0xa0, 0xff});
  const gfx::GlObject texture = gfx::make_texture(gl_, image);
  pictures_[last_.wanted_pictures[0]] = {texture.id(), "Magenta", 100, ""};
  frames(2);
  const auto pixels = picture(0);
  int shown = 0;
  for (int y = 0; y < height_; ++y)
    for (int x = 0; x < width_; ++x) shown += at(pixels, x, y) == 0xd020a0u;
  EXPECT_GT(shown, 100 * 50);
}

TEST_F(ImGuiRendererTest, the_same_state_gives_the_same_picture) {
  scripted_ = true;
  frames(3);
  const auto once = picture(0.5f);
  restart();
  frames(3);
  EXPECT_TRUE(once == picture(0.5f));
}

}  // namespace imgui_renderer_test
}  // namespace coaster::ui
