#include "ui/panels/palette.h"

#include <tuple>

#include "edit/commands/commands_sections.h"
#include "edit/commands/set_setting.h"
#include "ui/stage.h"
#include "world/aid_settings.h"
#include "world/appearance_settings.h"
#include "world/element_rows.h"
#include "world/panel_settings.h"

namespace coaster::ui {
namespace palette_test {

struct PaletteTest : Stage {};

TEST_F(PaletteTest, buttons_have_labels_at_usual_sizes_and_the_view_its_share) {
  ASSERT_TRUE(edit::apply(session_, files_, edit::Set<&world::Panels::workspace>{world::Workspace::build}));
  for (const auto& [width, height, scale] : {std::tuple{1280, 720, 1.0f}, {1280, 720, 1.5f}, {1920, 1080, 2.0f}}) {
    ASSERT_TRUE(edit::apply(session_, files_, edit::Set<&world::Appearance::ui_scale>{scale}));
    resize(width, height);
    frames(3);
    const Widget* loop = find("Elements/Loop");
    ASSERT_NE(loop, nullptr);
    EXPECT_EQ(loop->height, std::floor(36 * scale)) << "an icon above a label, " << width << " at " << scale;
    const view::Viewport& scene = host_->view().viewport;
    EXPECT_GE(scene.width * scene.height, 0.62f * static_cast<float>(width * height)) << width << " at " << scale;
  }
}

// At three frames a second a click and the key after it come in one frame.
TEST_F(PaletteTest, a_key_acts_on_what_the_click_before_it_chose) {
  ASSERT_TRUE(edit::apply(session_, files_, edit::Set<&world::Panels::workspace>{world::Workspace::build}));
  frames(3);
  click("Elements/Straight");
  const glm::vec2 loop = middle(*find("Elements/Loop"));
  commands_.clear();
  const auto button = [](bool down) { return platform::MouseButton{platform::Button::left, down, {}}; };
  frame({platform::MouseMove{loop.x, loop.y}, button(true), button(false), platform::KeyPress{platform::Key::enter},
         platform::KeyPress{platform::Key::enter, false}});
  EXPECT_TRUE(host_->input_waits());
  frames(4);
  EXPECT_FALSE(host_->input_waits());
  std::vector<world::ElementKind> placed;
  for (const edit::Command& command : commands_)
    if (const auto* const place = command.as<edit::PlaceElement>()) placed.push_back(place->what.kind);
  EXPECT_EQ(placed, std::vector{world::ElementKind::loop});
}

TEST_F(PaletteTest, a_double_click_shows_a_preview_and_a_later_click_hides_it) {
  ASSERT_TRUE(edit::apply(session_, files_, edit::Set<&world::Panels::workspace>{world::Workspace::build}));
  frames(3);
  click("Elements/Straight");
  click("Elements/Straight");
  EXPECT_TRUE(session_.settings.aids->show_element);
  frames(30);
  click("Elements/Straight");
  EXPECT_FALSE(session_.settings.aids->show_element);
}

}  // namespace palette_test
}  // namespace coaster::ui
