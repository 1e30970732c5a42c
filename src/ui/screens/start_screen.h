// The start screen: recent tracks, samples and challenges with pictures. While open it takes all keys and the mouse.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "ui/context/ui.h"
#include "ui/screens/challenge_list.h"

namespace coaster::ui {

class StartScreen {
 public:
  bool open() const { return open_; }
  void show() { open_ = appearing_ = true, samples_.clear(), challenges_.clear(); }
  void hide() { open_ = false; }

  // width, height: size of the window, px. Draws nothing while closed.
  void build(Ui& ui, const platform::Events& events, float width, float height);

 private:
  void build_choices(Ui& ui, float width);
  void build_tracks(Ui& ui);
  void build_challenges(Ui& ui, float width, float gap);
  // A picture of a track with its name below it.
  struct Card {
    std::string label, picture, help;  // widget label, track file, tooltip
    std::string name;                  // "": the name in the track
    int medal = 0;                     // drawn over the picture
  };
  bool draw(Ui& ui, const Card& card, float width);

  bool open_ = false, appearing_ = false;
  std::vector<std::filesystem::path> samples_;  // listed when the screen opens, as are the challenges
  std::vector<ChallengeEntry> challenges_;
};

}  // namespace coaster::ui
