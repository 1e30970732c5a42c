// The tables of statements of one line, one for each file of their readers, and what the readers share. Private to the
// grammar.
#pragma once

#include <span>
#include <string_view>

#include "base/words.h"
#include "script/statements.h"

namespace coaster::script {

using base::Words;

// A statement's first word, and the reader of the words behind it.
struct LineRow {
  std::string_view word;
  bool (*parse)(Words& words, Action& action);
};
std::span<const LineRow> expect_lines();
std::span<const LineRow> output_lines();
std::span<const LineRow> input_lines();
std::span<const LineRow> ui_lines();
std::span<const LineRow> aim_lines();

bool parse_lesson(Words& words, Action& action);  // opens a block; lines_expect.cpp

// Returns the column of the next word, or of the end of the line.
inline int next_column(const Words& words) { return words.at_end() ? words.end_column() : words.peek()->column; }

// Takes any of +shift, +ctrl and +alt.
void take_modifiers(Words& words, platform::Modifiers& modifiers);

}  // namespace coaster::script
