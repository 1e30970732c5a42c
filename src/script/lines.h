// Parses one line into an action: every statement except repeat, gesture, include and end, which span lines
// (grammar.cpp). Each file of readers has a table of its statements. Private to the grammar.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/words.h"
#include "script/statements.h"

namespace coaster::script {

using base::Words;

// Returns the first words that parse_line accepts, commands included.
std::vector<std::string> line_words();

// Parses the words of a line (at least one). On failure returns false and sets `error` to what was expected and where.
bool parse_line(std::span<const base::Token> line, base::TextError& error, Action& action);

// Returns what the message about an unknown first word ends with: the word that it and the next one are with a dot
// (ride start), else what another language's word is here, else the word that was probably meant, else one with the
// same last part (click: ui.click), else where all are listed.
std::string near_words(std::span<const base::Token> line);

// A statement's first word, and the reader of the words after it.
struct LineRow {
  std::string_view word;
  bool (*parse)(Words& words, Action& action);
};
std::span<const LineRow> expect_lines();
std::span<const LineRow> output_lines();
std::span<const LineRow> input_lines();
std::span<const LineRow> ui_lines();
std::span<const LineRow> aim_lines();

// Reads `rest` as the words of the command of that name, which is a statement's, too. Fails through `words`.
bool parse_command(std::string_view name, std::span<const base::Token> rest, Words& words, Action& action);

bool parse_lesson(Words& words, Action& action);  // opens a block; lines_expect.cpp

// Returns the column of the next word, or of the end of the line.
inline int next_column(const Words& words) { return words.at_end() ? words.end_column() : words.peek()->column; }

// Takes the next word; returns false at the end of the line.
inline bool take(Words& words, std::string_view what, base::Token& to) {
  const base::Token* const word = words.take(what);
  if (word) to = *word;
  return word != nullptr;
}

// Like Words::end() after a text or a path, whose words need quotes.
inline bool end_of_text(Words& words) {
  if (words.failed() || words.at_end()) return words.end();
  return words.fail(words.peek()->column,
                    "unexpected " + base::quoted_start(words.peek()->text) + ": a text with blanks needs quotes");
}

// Takes any of +shift, +ctrl and +alt.
void take_modifiers(Words& words, platform::Modifiers& modifiers);

}  // namespace coaster::script
