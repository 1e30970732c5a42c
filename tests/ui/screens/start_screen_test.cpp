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

}  // namespace start_screen_test
}  // namespace coaster::ui
