// The list of challenges, the program's and the user's, with the medals earned.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "ui/context/ui.h"

namespace coaster::ui {

struct ChallengeEntry {
  std::filesystem::path path;
  std::string name, teaches;
  std::filesystem::path track;  // its start track's file; empty when that is in the challenge itself
  std::string problem;          // why it cannot be begun; empty when it can
};

// What is in the folders, read when they are asked for; kept until the next time.
class ChallengeShelf {
 public:
  // The program's own (base::data_folder()), then the user's: files that end in .json, by name.
  void read(const std::filesystem::path& users);
  bool empty() const { return entries_.empty(); }
  const std::vector<ChallengeEntry>& entries() const { return entries_; }

 private:
  std::vector<ChallengeEntry> entries_;
};

// A row for each challenge in `height` px, scrolling; ui.panel names the widgets. What was clicked, or chosen by the
// arrow keys and Enter. `current`: the row that the keys are at.
std::optional<std::filesystem::path> draw_challenge_list(Ui& ui, const ChallengeShelf& shelf, int& current,
                                                         float height);

}  // namespace coaster::ui
