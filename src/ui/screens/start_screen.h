// The start screen: recent tracks, samples and challenges with pictures. While open it takes all keys and the mouse.
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "ui/context/query_widgets.h"
#include "ui/context/ui.h"

namespace coaster::ui {

// --- The list of challenges, the program's and the user's, with the medals earned

struct ChallengeEntry {
  std::filesystem::path path;
  std::string name, teaches;
  std::filesystem::path track;  // file of its start track; empty if the challenge itself contains it
  std::string problem;          // why it cannot start; empty if it can
  const std::string& help() const { return problem.empty() ? teaches : problem; }
};

// Returns the program's challenges (base::data_folder()), then the user's, each by file name. Reads the files.
std::vector<ChallengeEntry> read_challenges(const Ui& ui);

// Draws a scrolling list, `height` px high, with a row for each challenge; ui.panel names the widgets. Returns the one
// clicked, or selected with the arrow keys and Enter. `current`: the row that the keys are at.
std::optional<std::filesystem::path> draw_challenge_list(Ui& ui, std::span<const ChallengeEntry> challenges,
                                                         int& current, float height);

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
