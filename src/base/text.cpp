// Numbers: a thin layer over fmt and fast_float, because not every standard library has std::to_chars and
// std::from_chars for floating point. fmt prints the same shortest digits but chooses between fixed and scientific
// notation differently; fast_float reads the same numbers, but some versions return infinity or zero without an error
// for numbers out of range.
#include "base/text.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <numeric>

#include <fast_float/fast_float.h>
#include <fmt/format.h>

namespace coaster::base {
namespace {

bool is_control(char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; }

// Returns the code point of a well-formed character.
std::uint32_t code_point(std::string_view character) {
  const auto byte = [&](std::size_t i) { return static_cast<std::uint32_t>(static_cast<unsigned char>(character[i])); };
  if (character.size() == 1) return byte(0);
  std::uint32_t point = byte(0) & (0x7fu >> character.size());
  for (std::size_t i = 1; i < character.size(); ++i) point = point << 6 | (byte(i) & 0x3f);
  return point;
}

bool controls_text(std::uint32_t point) {
  if (point == '\n' || point == '\t') return false;
  return point < 0x20 || (point >= 0x7f && point < 0xa0) || point == 0x61c || point == 0x200e || point == 0x200f ||
         (point >= 0x2028 && point <= 0x202e) || (point >= 0x2066 && point <= 0x2069);
}

template <class T>
std::optional<T> parse_number(std::string_view text) {
  T value{};
  const char* const end = text.data() + text.size();
  const auto [stopped, code] = fast_float::from_chars(text.data(), end, value);
  if (code != std::errc{} || stopped != end || !std::isfinite(value)) return std::nullopt;
  const std::string_view digits = text.substr(0, text.find_first_of("eE"));
  if (value == 0 && digits.find_first_of("123456789") != std::string_view::npos) return std::nullopt;
  return value;
}

// A number other than zero, without its sign, as d.ddd * 10^power.
struct ScientificDigits {
  std::string digits;  // without leading and trailing zeros
  int power = 0;
};

// `text` is in fixed or scientific form.
ScientificDigits decimal(std::string_view text) {
  ScientificDigits result;
  const std::size_t mark = std::min(text.find('e'), text.size());
  const std::size_t point = std::min(text.find('.'), mark);
  const std::size_t first = text.find_first_of("123456789");
  if (mark < text.size()) result.power = std::atoi(text.data() + mark + 1);
  result.power += static_cast<int>(point) - static_cast<int>(first) - (first < point ? 1 : 0);
  for (const char c : text.substr(first, mark - first))
    if (c != '.') result.digits += c;
  result.digits.erase(result.digits.find_last_not_of('0') + 1);
  return result;
}

template <class T>
std::string print_number(T value) {
  std::string text = fmt::format("{}", value);
  if (!std::isfinite(value) || value == 0) return text;
  const auto [digits, power] = decimal(text);
  const int count = static_cast<int>(digits.size()), whole = power + 1;  // all digits, and those before the point
  const int fixed_size = whole >= count ? whole : whole > 0 ? count + 1 : count + 2 - whole;
  const int scientific_size = count + (count > 1 ? 1 : 0) + (std::abs(power) < 100 ? 4 : 5);
  const std::string_view sign = value < 0 ? "-" : "";
  if (fixed_size > scientific_size)
    return fmt::format("{}{}{}{}e{:+03}", sign, digits[0], count > 1 ? "." : "", std::string_view(digits).substr(1),
                       power);
  if (whole >= count) return fmt::format("{:.0f}", value);
  if (text.find('e') == std::string::npos) return text;
  if (whole > 0) return fmt::format("{}{}.{}", sign, digits.substr(0, whole), digits.substr(whole));
  return fmt::format("{}0.{:0>{}}", sign, digits, count - whole);
}

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

std::size_t utf8_length(std::string_view text) {
  if (text.empty()) return 0;
  const auto byte = [&](std::size_t i) { return i < text.size() ? static_cast<unsigned char>(text[i]) : 0u; };
  const unsigned lead = byte(0);
  if (lead < 0x80) return 1;
  const std::size_t length = lead >= 0xc2 && lead < 0xe0   ? 2
                             : lead >= 0xe0 && lead < 0xf0 ? 3
                             : lead >= 0xf0 && lead < 0xf5 ? 4
                                                           : 0;
  for (std::size_t i = 1; i < length; ++i)
    if ((byte(i) & 0xc0u) != 0x80) return 0;
  const unsigned second = byte(1);
  // Rejects overlong forms, surrogates and values beyond U+10FFFF.
  if ((lead == 0xe0 && second < 0xa0) || (lead == 0xed && second > 0x9f) || (lead == 0xf0 && second < 0x90) ||
      (lead == 0xf4 && second > 0x8f))
    return 0;
  return length;
}

bool is_printable_utf8(std::string_view text) {
  while (!text.empty()) {
    const std::size_t length = utf8_length(text);
    if (length == 0 || is_control(text[0])) return false;
    text.remove_prefix(length);
  }
  return true;
}

std::string printable_utf8(std::string_view text) {
  std::string printable;
  while (!text.empty()) {
    const std::size_t length = utf8_length(text);
    if (length == 0) printable += "\xEF\xBF\xBD";
    else if (is_control(text[0])) printable += '_';
    else printable += text.substr(0, length);
    text.remove_prefix(length == 0 ? 1 : length);
  }
  return printable;
}

std::string visible_text(std::string_view text) {
  const auto plain = [](char c) { return (c >= ' ' && c < 0x7f) || c == '\n' || c == '\t'; };
  std::string visible;
  visible.reserve(text.size());
  while (!text.empty()) {
    const auto end = std::find_if_not(text.begin(), text.end(), plain);
    visible.append(text.begin(), end);
    text.remove_prefix(static_cast<std::size_t>(end - text.begin()));
    if (text.empty()) break;
    const std::size_t length = text.starts_with("\r\n") ? 2 : utf8_length(text);
    const std::string_view character = text.substr(0, length == 0 ? 1 : length);
    if (character == "\r\n") visible += character;
    else if (length == 0) visible += fmt::format("\\x{:02x}", static_cast<unsigned char>(text[0]));
    else if (const std::uint32_t point = code_point(character); controls_text(point))
      visible += fmt::format("\\u{:04x}", point);
    else visible += character;
    text.remove_prefix(character.size());
  }
  return visible;
}

std::string_view utf8_start(std::string_view text, std::size_t most) {
  if (text.size() <= most) return text;
  while (most > 0 && (static_cast<unsigned char>(text[most]) & 0xc0) == 0x80) --most;
  return text.substr(0, most);
}

std::optional<double> parse_double(std::string_view text) { return parse_number<double>(text); }
std::optional<float> parse_float(std::string_view text) { return parse_number<float>(text); }

std::optional<std::int64_t> parse_int(std::string_view text) {
  std::int64_t value = 0;
  const char* const end = text.data() + text.size();
  const auto [stopped, code] = std::from_chars(text.data(), end, value);
  if (code != std::errc{} || stopped != end) return std::nullopt;
  return value;
}

bool is_number(std::string_view text) {
  double value = 0;
  const char* const end = text.data() + text.size();
  const auto [stopped, code] = fast_float::from_chars(text.data(), end, value);
  return code != std::errc::invalid_argument && stopped == end;
}

std::string to_text(float value) { return print_number(value); }
std::string to_text(double value) { return print_number(value); }

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

std::string lower(std::string_view text) {
  std::string out(text);
  for (char& c : out)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return out;
}

std::optional<bool> parse_switch(std::string_view word) {
  const std::string w = lower(word);
  if (w == "on" || w == "true" || w == "yes") return true;
  if (w == "off" || w == "false" || w == "no") return false;
  return std::nullopt;
}

bool parse_size(std::string_view text, int& width, int& height) {
  const std::size_t x = text.find_first_of("xX");
  if (x == std::string_view::npos) return false;
  const auto w = parse_int(text.substr(0, x)), h = parse_int(text.substr(x + 1));
  constexpr std::int64_t kMost = 16384;
  if (!w || !h || *w < 1 || *h < 1 || *w > kMost || *h > kMost || *w * *h > kMaxPixels) return false;
  width = static_cast<int>(*w), height = static_cast<int>(*h);
  return true;
}

TextError size_error(int column, std::string_view text) {
  const std::size_t x = std::min(text.find_first_of("xX"), text.size());
  const bool numbers = x < text.size() && is_number(text.substr(0, x)) && is_number(text.substr(x + 1));
  return {column, fmt::format("expected {}, found {}", kSizeWords, quoted_start(text)), numbers};
}

bool WordReader::accept(std::string_view word) {
  const Token* const next = peek();
  if (!next || next->quoted || next->text != word) return false;
  ++next_;
  return true;
}

const Token* WordReader::take(std::string_view what) {
  if (failed_) return nullptr;
  if (const Token* const next = peek()) return ++next_, next;
  fail(end_column(), fmt::format("expected {} at the end of the line", what));
  return nullptr;
}

std::optional<double> WordReader::number(std::string_view what) {
  const Token* const word = take(what);
  if (!word) return std::nullopt;
  std::string_view text = word->text;
  if (text.size() > 1 && text[0] == '+' && text[1] != '-') text.remove_prefix(1);
  const auto value = parse_double(text);
  if (!value) reject_number(what);
  return value;
}

std::optional<std::int64_t> WordReader::whole(std::string_view what, std::int64_t low, std::int64_t high) {
  const Token* const word = take(what);
  if (!word) return std::nullopt;
  const auto value = parse_int(word->text);
  if (value && *value >= low && *value <= high) return value;
  reject_number(fmt::format("{} ({}..{})", what, low, high));
  return std::nullopt;
}

std::optional<glm::vec3> WordReader::vector(std::string_view what) {
  glm::vec3 v{0};
  for (int axis = 0; axis < 3; ++axis) {
    const Token* const word = take(what);
    if (!word) return std::nullopt;
    const auto value = parse_float(word->text);
    if (!value) {
      reject_number(what);
      return std::nullopt;
    }
    v[axis] = *value;
  }
  return v;
}

std::optional<bool> WordReader::on_off() {
  const Token* const word = take("on or off");
  if (!word) return std::nullopt;
  if (word->text == "1") return true;
  if (word->text == "0") return false;
  const auto value = parse_switch(word->text);
  if (!value) reject("on or off");
  return value;
}

std::optional<std::size_t> WordReader::one_of(std::string_view what, std::span<const std::string> names) {
  const Token* const word = take(what);
  if (!word) return std::nullopt;
  const auto found = std::find(names.begin(), names.end(), word->text);
  if (found != names.end()) return static_cast<std::size_t>(found - names.begin());
  reject(what, suggestion(word->text, names));
  return std::nullopt;
}

bool WordReader::end() {
  if (failed_) return false;
  if (const Token* const extra = peek())
    return fail(extra->column, "unexpected " + base::quoted_start(extra->text) + " after the end of the statement");
  return true;
}

bool WordReader::reject(std::string_view what, std::string_view hint) {
  const Token& word = words_[next_ - 1];
  const std::string message = fmt::format("expected {}, found {}{}", what, base::quoted_start(word.text), hint);
  return fail({word.column, message, false, !hint.empty()});
}

bool WordReader::reject_number(std::string_view what) {
  reject(what);
  error_.out_of_range = is_number(words_[next_ - 1].text);
  return false;
}

bool WordReader::fail(TextError error) {
  if (!failed_) error_ = std::move(error);
  failed_ = true;
  return false;
}

int WordReader::end_column() const {
  if (words_.empty()) return 1;
  const Token& last = words_.back();
  return last.column + static_cast<int>(last.quoted ? base::quoted(last.text).size() : last.text.size());
}

}  // namespace coaster::base
