// Rows that show or set something of the session, shared by panels, pages and screens.
#pragma once

#include <filesystem>
#include <optional>
#include <string_view>

#include "ui/context/ui.h"

namespace coaster::ui {

// The value of a query, or nothing.
std::optional<query::Value> value_of(const Ui& ui, std::string_view query, std::string_view argument = {});

// A read_out() of a query's value with `decimals`; "--" where it has none or (times) where a script runs. `factor`
// converts units.
struct Shown {
  int decimals = 2;
  const char* unit = nullptr;  // null: the query's
  double factor = 1;
  bool is_time = false;
  bool warns = false;
};
void read_query(Ui& ui, std::string_view label, std::string_view query, std::string_view argument,
                std::string_view tooltip, Shown shown = {});

// Chooses what the track is coloured by.
void colouring_box(Ui& ui);

// The best medal of the challenge in that file, earned in this run or an earlier one. 0: none.
int known_medal(const Ui& ui, const std::filesystem::path& challenge);

}  // namespace coaster::ui
