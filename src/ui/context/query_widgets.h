// Rows that show a query's value, shared by panels, pages and screens.
#pragma once

#include <algorithm>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "edit/session/session.h"
#include "ui/context/ui.h"

namespace coaster::ui {

// Returns the value of a numeric query; nothing if it has none.
std::optional<double> number_of(const Ui& ui, std::string_view query);

// Shows a query's value by read_out() with `decimals`; "--" if it has none. `factor` converts units.
struct ShownValue {
  int decimals = 2;
  const char* unit = nullptr;  // null: the unit of the query
  double factor = 1;
  bool warns = false;
  std::string_view argument = {};  // argument of the query
};
void read_query(Ui& ui, std::string_view label, std::string_view query, std::string_view tooltip,
                const ShownValue& shown = {});

// Returns the user's settings for a change; the result is kept. Only if settings are kept (state.kept).
exchange::UserSettings& change_kept(Ui& ui);

// Returns the name of a file in a list, with its folder if others have the same name. `whole`: with the extension.
template <class Files>
std::string name_among(const std::filesystem::path& file, const Files& files, bool whole) {
  const auto name = [&](const std::filesystem::path& one) { return whole ? one.filename() : one.stem(); };
  const bool alone =
      std::count_if(files.begin(), files.end(), [&](const auto& other) { return name(other) == name(file); }) < 2;
  return (alone ? name(file) : file.parent_path().filename() / name(file)).string();
}

// Selects the colouring of the track.
void colouring_box(Ui& ui);

// Returns the best medal of the challenge in that file, earned in this run or an earlier one; 0: none.
int known_medal(const Ui& ui, const std::filesystem::path& challenge);

// --- The user's files

// Returns the .json files of a folder, by name; none if the folder does not exist.
std::vector<std::filesystem::path> json_files(const std::filesystem::path& folder);

// Returns the file after that of the session's challenge in its folder, by name; nothing after the last one.
std::optional<std::filesystem::path> challenge_after(const edit::ActiveChallenge& challenge);

}  // namespace coaster::ui
