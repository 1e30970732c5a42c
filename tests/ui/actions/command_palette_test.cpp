#include "ui/actions/command_palette.h"

#include <algorithm>

#include "edit/commands/commands_shape.h"
#include "ui/stage.h"

namespace coaster::ui {
namespace command_palette_test {

using platform::Key;
using platform::KeyPress;
using platform::TextInput;

struct CommandPaletteTest : Stage {};

TEST(command_palette, words_are_found_in_any_order_and_names_count_more_than_help) {
  const auto score = [](std::string_view words, std::string_view name, std::string_view help) {
    return match(words, name, help).score;
  };
  EXPECT_EQ(match("all sel", "Select all", "Select every knot.").missing, 0);
  EXPECT_GT(score("sel", "Select all", ""), score("sel", "Box select", ""));
  EXPECT_GT(score("sel", "Box select", ""), score("sel", "Unselect", ""));
  EXPECT_GT(score("knot", "move_knot", ""), score("knot", "Select all", "Select every knot."));
  EXPECT_GT(score("go", "Go", ""), score("go", "Goal", ""));
  EXPECT_EQ(match("", "anything", "").missing, 0);
}

TEST(command_palette, a_typo_is_nearer_than_another_word) {
  EXPECT_EQ(match("srceen", "Start screen", "").missing, 1);
  EXPECT_EQ(match("srceen", "Screenshot", "").missing, 1) << "the beginning of a word";
  EXPECT_EQ(match("xyz", "Select all", "Select every knot.").missing, 2);
  EXPECT_EQ(match("lap", "Map", "").missing, 2) << "short words are near to everything";
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
  key(Key::escape);
  key(Key::p, {.ctrl = true});
  frames(4);
  text("xyz");
  key(Key::enter);
  frames(3);
  text("c");
  EXPECT_EQ(find("Palette/Text")->value, "xyzc");
  EXPECT_TRUE(commands_.empty());
}

TEST_F(CommandPaletteTest, what_can_run_comes_first_and_near_misses_are_listed) {
  const auto lines = [&](const char* words) {
    key(Key::p, {.ctrl = true});
    frames(4);
    frame({TextInput{words}});
    frames(3);
    std::vector<std::pair<std::string, bool>> found;
    for (const Widget& widget : host_->widgets())
      if (widget.kind == "item" && widget.path.starts_with("Palette/"))
        found.emplace_back(widget.path.substr(8), widget.enabled);
    key(Key::escape);
    frames(2);
    return found;
  };
  const auto mirror = lines("mirror");
  ASSERT_GE(mirror.size(), 3u);
  EXPECT_TRUE(mirror[0].first.starts_with("mirror @knot")) << mirror[0].first;
  EXPECT_FALSE(mirror.back().second) << "no section is selected";
  const auto near = lines("mirror selected z");
  ASSERT_FALSE(near.empty());
  EXPECT_TRUE(near[0].first.starts_with("mirror @knot")) << near[0].first;
  const auto typo = lines("srceen");
  EXPECT_NE(std::ranges::find(typo, std::pair<std::string, bool>("Start screen", true)), typo.end());
  EXPECT_TRUE(lines("qqqq").empty());
  EXPECT_TRUE(lines("qqqq wwww").empty());
}

// The arrow keys go round the whole list; Enter completes the command of the row that they have come to.
TEST_F(CommandPaletteTest, arrows_choose_a_row_and_enter_takes_it) {
  const auto open = [&] {
    key(Key::escape);
    frames(2);
    key(Key::p, {.ctrl = true});
    frames(4);
    frame({TextInput{"force."}});
    frames(3);
    std::vector<std::string> commands;  // of the rows, with what follows the name
    for (const Widget& widget : host_->widgets())
      if (widget.kind == "item" && widget.path.starts_with("Palette/")) commands.push_back(widget.path.substr(8));
    return commands;
  };
  for (const std::vector<Key>& keys : {std::vector<Key>{},
                                       {Key::down},
                                       {Key::down, Key::down},
                                       {Key::down, Key::down, Key::up},
                                       {Key::up, Key::down}}) {
    const std::vector<std::string> rows = open();
    std::size_t row = 0;
    for (const Key one : keys) {
      key(one);
      frames(2);
      row = one == Key::down ? row + 1 : row - 1;  // up from the first row and down again: the first
    }
    frames(2);
    ASSERT_LT(row, rows.size());
    const std::string wanted = rows[row].substr(0, rows[row].find(' ') + 1);
    ASSERT_TRUE(wanted.starts_with("force") && wanted.ends_with(' ')) << "a command with arguments: " << rows[row];
    key(Key::enter);
    frames(3);
    ASSERT_NE(find("Palette/Text"), nullptr);
    EXPECT_EQ(find("Palette/Text")->value, wanted);
  }
}

TEST_F(CommandPaletteTest, a_wrong_argument_is_explained_and_stays) {
  key(Key::p, {.ctrl = true});
  frames(4);
  frame({TextInput{"mirror selected z"}});
  frames(2);
  key(Key::enter);
  frames(2);
  EXPECT_EQ(find("Palette/Text")->value, "mirror selected z");
  EXPECT_NE(host_->toast().find("across"), std::string::npos) << host_->toast();
  EXPECT_TRUE(all<edit::Mirror>().empty());
}

TEST_F(CommandPaletteTest, text_typed_right_after_ctrl_a_replaces_everything) {
  key(Key::p, {.ctrl = true});
  frames(4);
  frame({TextInput{"mirror"}});
  frame({KeyPress{Key::a, true, false, {.ctrl = true}}, KeyPress{Key::a, false, false, {}}, TextInput{"fov"}});
  frames(3);
  EXPECT_EQ(find("Palette/Text")->value, "fov");
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
