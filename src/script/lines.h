// Parses one line into an action: every statement except repeat, gesture, include and end, which span lines
// (grammar.cpp).
#pragma once

#include <span>
#include <string>
#include <vector>

#include "script/statements.h"

namespace coaster::script {

// Returns the first words that parse_line accepts, commands included.
std::vector<std::string> line_words();

// Parses the words of a line (at least one). On failure returns false and sets `error` to what was expected and where.
bool parse_line(std::span<const base::Token> line, base::TextError& error, Action& action);

}  // namespace coaster::script
