#include "base/text.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include <fmt/format.h>

#include "base/utf8.h"

namespace coaster::base {
namespace {

constexpr std::size_t kMostShown = 200;  // bytes of a word in a message

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r'; }

// True of escape, delete and the like. Blanks are none.
bool is_unexpected(char c) { return !is_blank(c) && (static_cast<unsigned char>(c) < 0x20 || c == 0x7f); }

TextError control_error(std::string_view line, std::size_t i) {
  return {static_cast<int>(i) + 1, fmt::format("unexpected control character {}", visible_text(line.substr(i, 1)))};
}

// Reads a quoted word whose opening quote is at `i`; moves `i` past the closing one.
bool read_quoted(std::string_view line, std::size_t& i, Token& token, TextError& error) {
  const std::size_t start = i++;
  token.quoted = true;
  while (i < line.size() && line[i] != '"') {
    char c = line[i];
    if (c == '\0') return error = control_error(line, i), false;
    if (c == '\\') {
      if (++i >= line.size()) break;
      switch (line[i]) {
        case 'n': c = '\n'; break;
        case '"': c = '"'; break;
        case '\\': c = '\\'; break;
        default: error = {static_cast<int>(i), "unknown escape; expected \\\", \\\\ or \\n"}; return false;
      }
    }
    token.text += c;
    ++i;
  }
  if (i >= line.size()) {
    error = {static_cast<int>(start) + 1, "the quote is not closed"};
    return false;
  }
  ++i;
  return true;
}

// Counts letters that are missing, extra or wrong, and neighbours that are swapped.
std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> before, last(b.size() + 1), row(b.size() + 1);  // of the letters of `a` so far
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    before = std::exchange(last, row);
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1)});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) row[j] = std::min(row[j], before[j - 2] + 1);
    }
  }
  return row[b.size()];
}

}  // namespace

bool tokenise(std::string_view line, std::vector<Token>& tokens, TextError& error) {
  tokens.clear();
  const auto fail = [&](std::size_t i, const char* message) {
    error = {static_cast<int>(i) + 1, message};
    return false;
  };
  for (std::size_t i = 0; i < line.size();) {
    if (is_blank(line[i])) {
      ++i;
      continue;
    }
    if (line[i] == '#') return true;
    Token token;
    token.column = static_cast<int>(i) + 1;
    if (line[i] == '"') {
      if (!read_quoted(line, i, token, error)) return false;
      if (i < line.size() && !is_blank(line[i])) return fail(i, "expected a blank behind the quote");
    } else {
      while (i < line.size() && !is_blank(line[i]) && line[i] != '#' && line[i] != '"') {
        if (is_unexpected(line[i])) return error = control_error(line, i), false;
        token.text += line[i++];
      }
      if (i < line.size() && line[i] == '"')
        return token.text.ends_with('(') ? fail(i - 1, "expected a blank instead of the bracket")
                                         : fail(i, "expected a blank before the quote");
    }
    tokens.push_back(std::move(token));
  }
  return true;
}

std::string quoted_start(std::string_view text) {
  return base::quoted(text.size() > kMostShown ? std::string(utf8_start(text, kMostShown)) + "..." : std::string(text));
}

std::string quoted_number(std::string_view text) {
  std::string point(text);
  if (const std::size_t comma = point.find(','); comma != std::string::npos) point[comma] = '.';
  return quoted_start(text) + (point != text && parse_double(point) ? ": decimals follow a point, not a comma" : "");
}

std::string quoted(std::string_view text) {
  std::string out = "\"";
  for (char c : text) {
    if (c == '"' || c == '\\' || c == '\n') out += '\\';
    out += c == '\n' ? 'n' : c;
  }
  return out + '"';
}

std::optional<std::string> nearest(std::string_view word, std::span<const std::string> candidates) {
  const std::string* best = nullptr;
  std::size_t best_distance = std::max<std::size_t>(1, word.size() / 3) + 1;
  for (const std::string& candidate : candidates) {
    if (std::max(word.size(), candidate.size()) - std::min(word.size(), candidate.size()) >= best_distance) continue;
    const std::size_t distance = edit_distance(word, candidate);
    if (distance < best_distance && distance < std::max(word.size(), candidate.size())) {
      best = &candidate;
      best_distance = distance;
    }
  }
  if (!best) return std::nullopt;
  return *best;
}

std::string suggestion(std::string_view word, std::span<const std::string> candidates) {
  const auto found = nearest(word, candidates);
  return found ? fmt::format("; did you mean \"{}\"?", *found) : "";
}

std::string cut_words(std::string_view message) {
  std::string cut;
  while (!message.empty()) {
    const std::size_t end = std::min(message.find_first_of(" \n"), message.size() - 1) + 1;
    const std::string_view word = message.substr(0, end);
    cut += end > kMostShown + 1 ? std::string(utf8_start(word, kMostShown)) + "... " : std::string(word);
    message.remove_prefix(end);
  }
  return cut;
}

std::string sentence(std::string error) {
  if (error.empty()) return error;
  if (error[0] >= 'a' && error[0] <= 'z') error[0] = static_cast<char>(error[0] - 'a' + 'A');
  return error.ends_with('.') || error.ends_with('?') ? error : error + '.';
}

std::string at_place(std::string_view file, int line, int column, std::string_view message) {
  return fmt::format("{}:{}:{}: error: {}", file, line, column, cut_words(message));
}

}  // namespace coaster::base
