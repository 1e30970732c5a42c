// Reads the words of a line.
#include "base/words.h"

#include <algorithm>

#include <fmt/format.h>

namespace coaster::base {

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

bool Words::accept(std::string_view word) {
  const Token* const next = peek();
  if (!next || next->quoted || next->text != word) return false;
  ++next_;
  return true;
}

const Token* Words::take(std::string_view what) {
  if (failed_) return nullptr;
  if (const Token* const next = peek()) return ++next_, next;
  fail(end_column(), fmt::format("expected {} at the end of the line", what));
  return nullptr;
}

std::optional<double> Words::number(std::string_view what) {
  const Token* const word = take(what);
  if (!word) return std::nullopt;
  std::string_view text = word->text;
  if (text.size() > 1 && text[0] == '+' && text[1] != '-') text.remove_prefix(1);
  const auto value = parse_double(text);
  if (!value) reject_number(what);
  return value;
}

std::optional<std::int64_t> Words::whole(std::string_view what, std::int64_t low, std::int64_t high) {
  const Token* const word = take(what);
  if (!word) return std::nullopt;
  const auto value = parse_int(word->text);
  if (value && *value >= low && *value <= high) return value;
  reject_number(fmt::format("{} ({}..{})", what, low, high));
  return std::nullopt;
}

std::optional<glm::vec3> Words::vector(std::string_view what) {
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

std::optional<bool> Words::on_off() {
  const Token* const word = take("on or off");
  if (!word) return std::nullopt;
  if (word->text == "1") return true;
  if (word->text == "0") return false;
  const auto value = parse_switch(word->text);
  if (!value) reject("on or off");
  return value;
}

std::optional<std::size_t> Words::one_of(std::string_view what, std::span<const std::string> names) {
  const Token* const word = take(what);
  if (!word) return std::nullopt;
  const auto found = std::find(names.begin(), names.end(), word->text);
  if (found != names.end()) return static_cast<std::size_t>(found - names.begin());
  reject(what, suggestion(word->text, names));
  return std::nullopt;
}

bool Words::end() {
  if (failed_) return false;
  if (const Token* const extra = peek())
    return fail(extra->column, "unexpected " + base::quoted_start(extra->text) + " after the end of the statement");
  return true;
}

bool Words::reject(std::string_view what, std::string_view hint) {
  const Token& word = words_[next_ - 1];
  const std::string message = fmt::format("expected {}, found {}{}", what, base::quoted_start(word.text), hint);
  return fail({word.column, message, false, !hint.empty()});
}

bool Words::reject_number(std::string_view what) {
  reject(what);
  error_.out_of_range = is_number(words_[next_ - 1].text);
  return false;
}

bool Words::fail(TextError error) {
  if (!failed_) error_ = std::move(error);
  failed_ = true;
  return false;
}

int Words::end_column() const {
  if (words_.empty()) return 1;
  const Token& last = words_.back();
  return last.column + static_cast<int>(last.quoted ? base::quoted(last.text).size() : last.text.size());
}

}  // namespace coaster::base
