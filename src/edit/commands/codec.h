// Commands as text, one per line: printing, parsing, help. Parsing a printed command gives the same command.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "base/text.h"
#include "edit/commands/command.h"
#include "world/document.h"

namespace coaster::edit {

std::string print(const Command& command);
// Returns what a command that changes the document does, as a sentence without a full stop: "Moved k4". Sections have
// their titles in `document`, the one before the command.
std::string done(const Command& command, const world::Document& document);

// One row per kind of command, for help, completion and the command palette: "move @knot to X Y Z".
struct CommandHelp {
  CommandInfo info;
  std::string usage;
};
const std::vector<CommandHelp>& command_table();

// True if `word` is the first word of a command.
bool is_command(std::string_view word);

// Parses the words of a line. Vectors take three numbers; switches on/off; methods their names. On failure `error` has
// the column of the wrong word (or one past the last) and says what was expected, with the nearest valid word.
base::Result<Command> parse(std::span<const base::Token> tokens, base::TextError& error);

}  // namespace coaster::edit
