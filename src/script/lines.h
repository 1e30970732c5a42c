// One line's words into an action: every statement but repeat, gesture, include and end, which span lines
// (grammar.cpp).
#pragma once

#include <span>
#include <string>
#include <vector>

#include "script/statements.h"

namespace coaster::script {

// The first words that parse_line knows, commands included.
std::vector<std::string> line_words();

// Parses the words of a line (at least one). False: `error` says what was expected and where.
bool parse_line(std::span<const base::Token> line, base::TextError& error, Action& action);

}  // namespace coaster::script
