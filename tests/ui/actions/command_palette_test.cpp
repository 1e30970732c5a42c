#include "ui/actions/command_palette.h"

#include "ui/stage.h"

namespace coaster::ui {
namespace command_palette_test {

using platform::Key;
using platform::KeyPress;
using platform::TextInput;

struct CommandPaletteTest : Stage {};

TEST(command_palette, words_are_found_in_any_order_and_names_count_more_than_help) {
  EXPECT_EQ(match("xyz", "Select all", "Select every knot."), 0);
  EXPECT_GT(match("all sel", "Select all", "Select every knot."), 0);
  EXPECT_GT(match("sel", "Select all", ""), match("sel", "Box select", ""));
  EXPECT_GT(match("knot", "move @knot", ""), match("knot", "Select all", "Select every knot."));
  EXPECT_GT(match("", "anything", ""), 0);
}

TEST_F(CommandPaletteTest, a_key_pressed_right_after_it_opens_is_text_and_no_shortcut) {
  const auto before = world::hash(session_.document);
  frame({KeyPress{Key::p, true, false, {.ctrl = true}}, KeyPress{Key::c, true, false, {}}, TextInput{"c"},
         KeyPress{Key::a, true, false, {}}, TextInput{"a"}});
  for (int i = 0; i < 8; ++i) frame();
  ASSERT_NE(find("Palette/Text"), nullptr);
  EXPECT_EQ(find("Palette/Text")->value, "ca");
  EXPECT_EQ(world::hash(session_.document), before) << "C adds a knot";
}

TEST_F(CommandPaletteTest, what_cannot_run_now_says_why_and_words_without_a_match_can_be_typed_on) {
  const auto text = [&](const char* words) {
    frame({TextInput{words}});
    frames(3);
  };
  key(Key::p, {.ctrl = true});
  frames(4);
  text("mirror section");
  const Widget* const line = find("Palette/Mirror section");
  ASSERT_NE(line, nullptr) << "no section is selected";
  EXPECT_FALSE(line->enabled);
  key(Key::enter);
  frames(3);
  EXPECT_EQ(find("Palette/Text")->value, "mirror section") << "still open";
  EXPECT_NE(host_->toast().find("elect"), std::string::npos) << host_->toast();
  text("xyz");
  key(Key::enter);
  frames(3);
  text("c");
  EXPECT_EQ(find("Palette/Text")->value, "mirror sectionxyzc");
  EXPECT_TRUE(commands_.empty());
}

TEST_F(CommandPaletteTest, a_camera_line_keeps_the_values_that_it_does_not_give) {
  ASSERT_TRUE(edit::apply(session_, files_, edit::set_camera({{1, 2, 3}, 40, 20, 60})).ok());
  key(Key::p, {.ctrl = true});
  frames(4);
  frame({TextInput{"camera target 4 5 6 distance 30"}});
  frames(2);
  key(Key::enter);
  frames(2);
  const world::Camera& camera = session_.settings.camera;
  EXPECT_EQ(camera.target, glm::vec3(4, 5, 6));
  EXPECT_EQ(camera.distance, 30);
  EXPECT_EQ(camera.yaw_deg, 40);
  EXPECT_EQ(camera.pitch_deg, 20);
}

}  // namespace command_palette_test
}  // namespace coaster::ui
