// The rows of text files of numbers, as programs that people pass them through write them.
#pragma once

#include <algorithm>
#include <array>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include "exchange/nolimits/nl2_csv.h"
#include "world/components.h"

namespace coaster::exchange {

using Cells = std::array<std::string_view, kNl2Columns.size()>;

inline std::string_view trimmed(std::string_view text, std::string_view blanks = " ") {
  text.remove_prefix(std::min(text.find_first_not_of(blanks), text.size()));
  return text.substr(0, text.find_last_not_of(blanks) + 1);
}

// Returns a cell's text without blanks and quotes around it, a number without a plus sign.
inline std::string_view content(std::string_view cell) {
  cell = trimmed(cell);
  const bool in_quotes = cell.size() >= 2 && cell.front() == '"' && cell.back() == '"';
  if (in_quotes) cell = trimmed(cell.substr(1, cell.size() - 2));
  const bool plus = cell.size() >= 2 && cell[0] == '+' && (cell[1] == '.' || (cell[1] >= '0' && cell[1] <= '9'));
  return plus ? cell.substr(1) : cell;
}

// Iterates over the lines of a text, numbered from 1, without line endings: LF, CRLF or CR. Skips blank lines and
// comments: lines that start with # or //.
class LineReader {
 public:
  explicit LineReader(std::string_view text) : rest_(text) {
    if (rest_.starts_with("\xef\xbb\xbf")) rest_.remove_prefix(3);
  }
  bool next(std::string_view& line) {
    do {
      if (rest_.empty()) return false;
      const std::size_t end = rest_.find_first_of("\r\n");
      line = rest_.substr(0, end);
      ended_ = end != std::string_view::npos;
      rest_.remove_prefix(line.size());
      rest_.remove_prefix(rest_.starts_with("\r\n") ? 2 : ended_ ? 1 : 0);
      ++number_;
      line.remove_prefix(std::min(line.find_first_not_of(" \t"), line.size()));
    } while (line.empty() || line.starts_with('#') || line.starts_with("//"));
    return true;
  }
  int number() const { return number_; }
  bool ended() const { return ended_; }  // the line ends with a newline

 private:
  std::string_view rest_;
  int number_ = 0;
  bool ended_ = false;
};

struct Separator {
  char mark;
  std::string_view name;
};
// Commas after semicolons: they may be decimal ones there.
inline constexpr Separator kSeparators[]{{'\t', "tabs"}, {';', "semicolons"}, {',', "commas"}, {' ', "blanks"}};

// Splits a line into cells; returns at most one more than there are columns. Separators at its end count for nothing,
// several blanks as one.
inline std::size_t split(std::string_view line, char separator, Cells& cells) {
  std::size_t count = 0;
  for (;;) {
    const std::size_t end = line.find(separator);
    if (count < cells.size()) cells[count] = content(line.substr(0, end));
    ++count;
    if (count == cells.size() && line.find_first_not_of(" \t,;", end) == std::string_view::npos) return count;
    if (end == std::string_view::npos || count > cells.size()) return count;
    line.remove_prefix(end + 1);
    if (separator == ' ') line.remove_prefix(std::min(line.find_first_not_of(' '), line.size()));
  }
}

// Returns what a file's number has to be, for messages: positions are in metres, and a file in millimetres goes beyond.
inline std::string within_text(double limit) {
  return limit == world::kMaxCoordinate ? fmt::format("a position within {:.0f} m", limit)
                                        : fmt::format("a number within {:.6g}", limit);
}

}  // namespace coaster::exchange
