// The cards of the start screen.
#include "ui/screens/start_screen.h"

#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <fstream>
#include <string>
#include <string_view>
#include <vector>

#include "base/scratch_folder.h"
#include "edit/commands/commands_session.h"
#include "ui/stage.h"
#include "ui/widgets/theme.h"

namespace coaster::ui {
namespace start_screen_test {

struct StartScreenTest : Stage {};

TEST_F(StartScreenTest, a_track_that_nobody_has_named_is_called_by_its_file) {
  const test::ScratchFolder scratch;
  user_.emplace();
  for (const auto& [file, name] : {std::pair{"first ride.json", "Untitled"}, {"second.json", "Red"}}) {
    const std::string path = (scratch.path() / file).string();
    std::ofstream(path) << "{}";
    user_->settings.recent.push_back(path);
    pictures_[path] = {0, name, 100, ""};
  }
  host_->show_start();
  frames(2);
  const auto shown = [&](const std::string& file) {
    const Widget* const card = find("Start/Recent/" + file);
    return card != nullptr ? card->value : "no such card";
  };
  EXPECT_EQ(shown("first ride"), "first ride");
  EXPECT_EQ(shown("second"), "Red");
}

TEST_F(StartScreenTest, its_buttons_have_their_keys) {
  ASSERT_TRUE(edit::apply(session_, files_, edit::NewTrack{}).ok());  // nothing to ask about
  for (const auto& [letter, dialog] : {std::pair{platform::Key::o, "Open"}, {platform::Key::h, "Challenges"}}) {
    host_->show_start();
    frames(2);
    ASSERT_NE(find("Start/New track"), nullptr);
    key(letter, {.ctrl = true});
    frames(2);
    EXPECT_EQ(find("Start/New track"), nullptr) << dialog;
    EXPECT_NE(find(std::string(dialog) + "/Cancel"), nullptr) << dialog;
    key(platform::Key::escape);
    frames(2);
    EXPECT_NE(find("Start/New track"), nullptr) << "after " << dialog;
  }
  key(platform::Key::n, {.ctrl = true});
  EXPECT_EQ(all<edit::NewTrack>().size(), 1u);
  frames(2);
  EXPECT_EQ(find("Start/New track"), nullptr);
}

TEST_F(StartScreenTest, leaves_other_keys_to_the_track) {
  host_->show_start();
  frames(2);
  const std::size_t before = commands_.size();
  for (const platform::Key other : {platform::Key::c, platform::Key::r, platform::Key::f9})
    EXPECT_FALSE(frame({platform::KeyPress{other, true, false, {}}}).toggles_full_screen);
  EXPECT_EQ(commands_.size(), before);
  EXPECT_TRUE(frame({platform::KeyPress{platform::Key::f11, true, false, {}}}).toggles_full_screen);
  EXPECT_FALSE(frame({platform::KeyPress{platform::Key::f11, true, true, {}}}).toggles_full_screen) << "held";
}

TEST_F(StartScreenTest, arrows_and_Enter_choose) {
  ASSERT_TRUE(edit::apply(session_, files_, edit::NewTrack{}).ok());  // nothing to ask about
  const auto choose = [&](std::initializer_list<platform::Key> keys) {
    host_->show_start();
    frames(3);
    for (const platform::Key k : keys) key(k), frames(2);
    commands_.clear();
    key(platform::Key::enter);
    frames(3);
  };
  using platform::Key;
  choose({Key::down});
  EXPECT_NE(find("Open/Cancel"), nullptr) << "the second choice: nothing can be continued";
  EXPECT_EQ(commands_.size(), 0u);
  key(Key::escape);
  frames(2);
  choose({Key::right});
  ASSERT_EQ(all<edit::LoadTrack>().size(), 1u) << "a sample, beside the choices";
  EXPECT_EQ(find("Start/New track"), nullptr);
}

TEST_F(StartScreenTest, a_search_of_actions_returns_to_the_track) {
  host_->show_start();
  frames(2);
  key(platform::Key::p, {.ctrl = true});
  frames(2);
  EXPECT_NE(find("Palette/Text"), nullptr);
  EXPECT_EQ(find("Start/New track"), nullptr);
}

// Four in a row, of one size and one distance, the rows of all groups below one another.
TEST_F(StartScreenTest, cards_are_in_rows_of_four_within_the_page) {
  const test::ScratchFolder scratch;
  user_.emplace();
  for (const char* const name : {"one", "two", "three", "four", "five", "six"}) {
    const std::string path = (scratch.path() / (std::string(name) + ".json")).string();
    std::ofstream(path) << "{}";
    user_->settings.recent.push_back(path);
  }
  for (const auto& [width, height] : {std::pair{1280, 720}, {1920, 1080}}) {
    resize(width, height);
    host_->show_start();
    frames(3);
    float least = 1e9f, wide = 0, gap = 0;
    for (const char* const group : {"Start/Recent/", "Start/Samples/", "Start/Challenges/"}) {
      std::vector<Widget> cards;
      for (const Widget& w : host_->widgets())
        if (w.path.starts_with(group)) cards.push_back(w);
      ASSERT_GE(cards.size(), 4u) << group;
      if (std::string(group) == "Start/Recent/") {
        EXPECT_EQ(cards.size(), 4u) << "the newest alone";
        least = cards[0].x, wide = cards[0].width, gap = cards[1].x - cards[0].x - wide;
        EXPECT_GT(gap, 4);
        EXPECT_LT(gap, 0.2f * wide);
      }
      for (std::size_t i = 0; i < cards.size(); ++i) {
        EXPECT_NEAR(cards[i].x, least + static_cast<float>(i % 4) * (wide + gap), 0.6f) << cards[i].path;
        EXPECT_EQ(cards[i].width, wide);
        EXPECT_EQ(cards[i].y, cards[i - i % 4].y) << cards[i].path;
        EXPECT_NEAR(cards[i].height, wide * 9 / 16 + 1.4f * 14, 8) << "a picture and a line";
        if (i >= 4) {
          EXPECT_GT(cards[i].y, cards[i - 4].y + cards[i - 4].height) << cards[i].path;
        }
      }
    }
    EXPECT_LT(least + 4 * wide + 3 * gap, static_cast<float>(width));
    const Widget& choice = *find("Start/Continue");
    EXPECT_LT(choice.x + choice.width, least);
  }
}

// Between the words under the title and the first choice is more room than between two choices.
TEST_F(StartScreenTest, the_title_stands_apart_where_it_has_room) {
  const auto title_room = [&](int height) {  // the headings of the pictures begin at the top
    resize(1280, height);
    host_->show_start();
    frames(3);
    return find("Start/Continue")->y - find("Start/Samples")->y;
  };
  EXPECT_GT(title_room(720), 64 + 36 + 17);
  const Widget &first = *find("Start/Continue"), &second = *find("Start/New track");
  float words = 0;
  for (const ImGuiWindow* const window : ImGui::GetCurrentContext()->Windows)
    if (std::string_view(window->Name).find("##choices") != std::string_view::npos)
      for (const ImDrawVert& v : window->DrawList->VtxBuffer)
        if (((v.col ^ packed(palette().dim)) & 0xffffffu) == 0 && v.pos.y < first.y) words = std::max(words, v.pos.y);
  ASSERT_GT(words, 0);
  EXPECT_GT(first.y - words, 1.5f * (second.y - first.y - first.height));
  EXPECT_LT(title_room(340), 10) << "there is no room for it";
}

}  // namespace start_screen_test
}  // namespace coaster::ui
