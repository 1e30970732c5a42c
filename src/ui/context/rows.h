// Rows that show or set something of the session, shared by panels, pages and screens.
#pragma once

#include <algorithm>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "ui/context/ui.h"

namespace coaster::ui {

// The value of a query that is a number, or nothing.
std::optional<double> number_of(const Ui& ui, std::string_view query);

// A read_out() of a query's value with `decimals`; "--" where it has none. `factor`
// converts units.
struct Shown {
  int decimals = 2;
  const char* unit = nullptr;  // null: the query's
  double factor = 1;
  bool warns = false;
  std::string_view argument = {};  // of the query
};
void read_query(Ui& ui, std::string_view label, std::string_view query, std::string_view tooltip,
                const Shown& shown = {});

// The user's settings, to be changed and kept. Only where something is kept (state.kept).
exchange::UserSettings& change_kept(Ui& ui);

// The name of a file in a list, with its folder if others have the same name. `whole`: with the extension.
template <class Files>
std::string name_among(const std::filesystem::path& file, const Files& files, bool whole) {
  const auto name = [&](const std::filesystem::path& one) { return whole ? one.filename() : one.stem(); };
  const bool alone =
      std::count_if(files.begin(), files.end(), [&](const auto& other) { return name(other) == name(file); }) < 2;
  return (alone ? name(file) : file.parent_path().filename() / name(file)).string();
}

// Chooses what the track is coloured by.
void colouring_box(Ui& ui);

// The best medal of the challenge in that file, earned in this run or an earlier one. 0: none.
int known_medal(const Ui& ui, const std::filesystem::path& challenge);

}  // namespace coaster::ui
