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
void build_palette(Act& act, CommandPalette& palette);

// Returns how well `words` (separated by spaces) match an entry. 0 unless all of them occur in name or help, ignoring
// case.
int match(std::string_view words, std::string_view name, std::string_view help);

}  // namespace coaster::ui
