// Ctrl+P: every action and every command in one list, found by typing; a whole command line is run as it stands.
#pragma once

#include <array>
#include <string>

#include "ui/actions/actions.h"

namespace coaster::ui {

struct CommandPalette {
  bool open = false, appearing = false;
  std::array<char, 512> text{};
  int row = 0;          // the chosen one of those that match
  bool filled = false;  // the text was completed: the cursor goes to its end
};

void toggle_palette(CommandPalette& palette);
void build_palette(Act& act, CommandPalette& palette);

// How well `words` (typed, separated by spaces) fit an entry; 0: not at all. All of them must occur in name or help,
// case aside.
int match(std::string_view words, std::string_view name, std::string_view help);

}  // namespace coaster::ui
