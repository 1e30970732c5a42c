// The list of challenges, the program's and the user's, with the medals earned.
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "ui/context/ui.h"
#include "ui/context/user_files.h"

namespace coaster::ui {

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

}  // namespace coaster::ui
