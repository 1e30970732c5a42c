// The statements of scripts, one row each, as commands are. Parsing, --help-script, the usages in errors, suggestions
// for unknown words and the tables of docs/script.md read these rows. Private to the grammar.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/text.h"
#include "script/statements.h"

namespace coaster::script {

using base::WordReader;

// Reads the words after the first one up to the end of the line. `which`: the first word's place in the row's words.
using Reader = bool (*)(WordReader& words, std::size_t which, Action& action);

struct StatementRow {
  std::string_view usage;  // its words, then what follows them: "ui.open|close \"PATH\""; a block's ends in "... end"
  std::string_view help;
  Reader read = nullptr;  // null: grammar.cpp reads it, or the row above, of which this is another form, does
};
struct RowGroup {
  std::string_view title;
  std::span<const StatementRow> rows;
};
// Returns the rows as help shows them.
std::span<const RowGroup> row_groups();
std::span<const StatementRow> input_rows();  // statement_rows_input.cpp

// Returns the words of a row: "ui.open" and "ui.close".
std::vector<std::string> words_of(const StatementRow& row);
// Returns the usage of the first row of that word; empty if it is of none.
std::string_view usage(std::string_view word);
// True if the word opens a block of lines up to "end".
bool opens_block(std::string_view word);

// Parses a line (at least one word) that is a statement of a row with a reader, or a command. On failure returns false
// and sets `error` to what was expected and where, with the usage if no word was probably meant.
bool parse_line(std::span<const base::Token> line, base::TextError& error, Action& action);

// Returns what the message about an unknown first word ends with: the word that it and the next one are with a dot
// (ride start), else what another language's word is here, else the word that was probably meant, else one with the
// same last part (click: ui.click), else where all are listed.
std::string near_words(std::span<const base::Token> line);

// Words of other languages, separated by blanks, and what a script says in their place: a word or, after a semicolon,
// how to do it.
struct ForeignWords {
  std::string_view words, here;
};
std::span<const ForeignWords> foreign_words();

// A Reader from a function that fills one kind of statement.
template <auto fill>
struct ReaderOf;
template <class S, bool (*fill)(WordReader&, S&)>
struct ReaderOf<fill> {
  static bool read(WordReader& words, std::size_t, Action& action) {
    S made;
    if (!fill(words, made)) return false;
    action = std::move(made);
    return words.end();
  }
};
template <auto fill>
inline constexpr Reader reads = ReaderOf<fill>::read;

// Reads `rest` as the words of the command of that name, which is a statement's, too. Fails through `words`.
bool read_command(std::string_view name, std::span<const base::Token> rest, WordReader& words, Action& action);

// Returns the column of the next word, or of the end of the line.
inline int next_column(const WordReader& words) { return words.at_end() ? words.end_column() : words.peek()->column; }

// The next functions read into a field; they return false if they failed through `words`.
inline bool take(WordReader& words, std::string_view what, base::Token& to) {
  const base::Token* const word = words.take(what);
  if (word) to = *word;
  return word != nullptr;
}
inline bool take(WordReader& words, std::string_view what, std::string& to) {
  const base::Token* const word = words.take(what);
  if (word) to = word->text;
  return word != nullptr;
}
template <class N>
bool whole(WordReader& words, std::string_view what, std::int64_t low, std::int64_t high, N& to) {
  const auto value = words.whole(what, low, high);
  if (value) to = static_cast<N>(*value);
  return value.has_value();
}
template <class N>
bool number(WordReader& words, std::string_view what, N& to) {
  const auto value = words.number(what);
  if (value) to = static_cast<N>(*value);
  return value.has_value();
}
// `what` says the range.
bool number_within(WordReader& words, std::string_view what, double low, double high, float& to);
// Takes one of the words; returns its place among them.
std::optional<std::size_t> choice(WordReader& words, std::span<const std::string> names);
// Like WordReader::end() after a text or a path, whose words need quotes.
bool end_of_text(WordReader& words);

}  // namespace coaster::script
