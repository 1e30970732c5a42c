// The cards of the start screen.
#include "ui/screens/start_screen.h"

#include <fstream>

#include "base/scratch_folder.h"
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

TEST_F(StartScreenTest, leaves_only_full_screen_of_all_keys) {
  host_->show_start();
  frames(2);
  const std::size_t before = commands_.size();
  for (const platform::Key other : {platform::Key::c, platform::Key::space, platform::Key::f9})
    EXPECT_FALSE(frame({platform::KeyPress{other, true, false, {}}}).toggles_full_screen);
  EXPECT_EQ(commands_.size(), before);
  EXPECT_TRUE(frame({platform::KeyPress{platform::Key::f11, true, false, {}}}).toggles_full_screen);
  EXPECT_FALSE(frame({platform::KeyPress{platform::Key::f11, true, true, {}}}).toggles_full_screen) << "held";
}

}  // namespace start_screen_test
}  // namespace coaster::ui
