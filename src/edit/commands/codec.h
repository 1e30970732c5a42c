// Commands as text, one a line: printing, parsing, help. What print writes, parse reads back to the same command.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "base/text.h"
#include "edit/commands/commands.h"

namespace coaster::edit {

std::string print(const Command& command);

// One row per kind of command, for help, completion and the palette: "move @knot to X Y Z".
struct CommandHelp {
  CommandInfo info;
  std::string usage;
};
const std::vector<CommandHelp>& command_table();

// True when `word` is the first word of some command.
bool is_command(std::string_view word);

// Parses the tokens of a line. Vectors take three numbers; switches on/off; methods their names. On failure `error` has
// the column of the offending word (or one past the last) and says what was expected, with the nearest valid word.
base::Result<Command> parse(std::span<const base::Token> tokens, base::TextError& error);

}  // namespace coaster::edit
