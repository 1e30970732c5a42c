// The command palette (Ctrl+P): a searchable list of all actions and commands, which also runs whole command lines.
#pragma once

#include <array>

#include "ui/actions/actions.h"

namespace coaster::ui {

struct CommandPalette {
  bool open = false, appearing = false;
  std::array<char, 512> text{};
  int row = 0;          // the highlighted row among the matches
  bool filled = false;  // the text was completed: the cursor goes to its end
};

void toggle_palette(CommandPalette& palette);
void build_palette(ActionContext& act, CommandPalette& palette);

// How well words match an entry.
struct Match {
  int missing = 0;  // 2 for each word that occurs neither in name nor help, 1 for one that is a typo of the name's
  int score = 0;    // more for the beginning of a word of the name than for a part of one, and for those than for help
};
// Matches words (separated by spaces, in any order) with an entry, ignoring case.
Match match(std::string_view words, std::string_view name, std::string_view help);

}  // namespace coaster::ui
