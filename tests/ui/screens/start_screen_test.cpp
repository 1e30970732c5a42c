// The cards of the start screen.
#include "ui/screens/start_screen.h"

#include <fstream>

#include "base/scratch_folder.h"
#include "edit/commands/commands_session.h"
#include "ui/stage.h"

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
  ASSERT_EQ(all<edit::Load>().size(), 1u) << "a sample, beside the choices";
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

}  // namespace start_screen_test
}  // namespace coaster::ui
