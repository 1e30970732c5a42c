// The list of challenges, the program's and the user's, with the medals earned.
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "ui/context/ui.h"

namespace coaster::ui {

struct ChallengeEntry {
  std::filesystem::path path;
  std::string name, teaches;
  std::filesystem::path track;  // its start track's file; empty when that is in the challenge itself
  std::string problem;          // why it cannot be begun; empty when it can
  const std::string& help() const { return problem.empty() ? teaches : problem; }
};

// The files of a folder that end in .json, by name; none where there is no such folder.
std::vector<std::filesystem::path> json_files(const std::filesystem::path& folder);

// The program's own challenges (base::data_folder()), then the user's, each by file name. Reads the files.
std::vector<ChallengeEntry> read_challenges(const Ui& ui);

// A row for each challenge in `height` px, scrolling; ui.panel names the widgets. What was clicked, or chosen by the
// arrow keys and Enter. `current`: the row that the keys are at.
std::optional<std::filesystem::path> draw_challenge_list(Ui& ui, std::span<const ChallengeEntry> challenges,
                                                         int& current, float height);

}  // namespace coaster::ui
