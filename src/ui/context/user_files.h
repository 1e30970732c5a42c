// The user's files: challenges with their medals, tracks and settings.
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "edit/session/session.h"

namespace coaster::ui {

// Returns the .json files of a folder, by name; none if the folder does not exist.
std::vector<std::filesystem::path> json_files(const std::filesystem::path& folder);

// Returns the file after that of the session's challenge in its folder, by name; nothing after the last one.
std::optional<std::filesystem::path> challenge_after(const edit::ActiveChallenge& challenge);

}  // namespace coaster::ui
