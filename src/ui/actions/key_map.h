// Which keys do what: those of the table of actions, changed by what the user's settings say.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "exchange/own/settings_file.h"
#include "platform/events.h"

namespace coaster::ui {

class KeyMap {
 public:
  // By the rows of actions(). What cannot be done goes to `problems`, a line each, and leaves the row as it is: names
  // that no action has, keys that do not exist, keys wanted by two. A key that is given away is taken from the action
  // whose own it was, and that is told, too.
  static KeyMap make(std::span<const exchange::KeyChoice> choices, std::vector<std::string>& problems);

  // The keys of a row of actions(): none, one or two.
  std::span<const platform::Chord> chords(std::size_t row) const { return rows_[row]; }
  // The first of them, "" without one.
  std::string shown(std::size_t row) const;
  std::string shown(std::string_view action) const;

 private:
  std::vector<std::vector<platform::Chord>> rows_;
};

// "HELP Key C.", "HELP Keys Ctrl+Y, Ctrl+Shift+Z.", or the help alone.
std::string with_keys(const KeyMap& keys, std::string_view help, std::string_view action);

}  // namespace coaster::ui
