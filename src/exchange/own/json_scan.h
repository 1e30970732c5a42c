// Reads plain JSON several times as fast as the library's parser. Private to this room.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "base/text.h"

namespace coaster::exchange {

// Calls the events of the library's SAX interface for a whole text. Returns false at the first thing that it does not
// handle: every error, an escape in a string, an integer of 19 digits; and if an event returns false. The caller then
// starts again with the library, which handles all of JSON and describes its errors. Whatever this function accepts
// gives the same values as the library.
template <class Events>
class JsonScan {
 public:
  JsonScan(std::string_view text, Events& events) : text_(text), events_(events) {}

  bool all() { return value() && (skip_blanks(), at_ == text_.size()); }

 private:
  static constexpr std::size_t kUnknownSize = static_cast<std::size_t>(-1);

  // Returns the next character; 0 at the end.
  char next() const { return at_ < text_.size() ? text_[at_] : '\0'; }
  bool take(char c) { return next() == c && (++at_, true); }
  void skip_blanks() {
    for (char c = next(); c == ' ' || c == '\n' || c == '\r' || c == '\t'; c = next()) ++at_;
  }
  bool word(std::string_view word) {
    const bool is = text_.substr(at_, word.size()) == word;
    at_ += word.size();
    return is;
  }

  // Recursive: the events limit the depth.
  bool value() {
    skip_blanks();
    switch (next()) {
      case '{': return object();
      case '[': return array();
      case '"': return string() && events_.string(string_);
      case 't': return word("true") && events_.boolean(true);
      case 'f': return word("false") && events_.boolean(false);
      case 'n': return word("null") && events_.null();
      default: return number();
    }
  }

  bool object() {
    ++at_;
    if (!events_.start_object(kUnknownSize)) return false;
    for (skip_blanks(); !take('}'); skip_blanks()) {
      if (next() != '"' || !string() || !events_.key(string_)) return false;
      skip_blanks();
      if (!take(':') || !value() || !goes_on('}')) return false;
    }
    return events_.end_object();
  }

  bool array() {
    ++at_;
    if (!events_.start_array(kUnknownSize)) return false;
    for (skip_blanks(); !take(']');)
      if (!value() || !goes_on(']')) return false;
    return events_.end_array();
  }

  // Call after a value: returns true before `end`, and after a comma that is not followed by `end`.
  bool goes_on(char end) {
    skip_blanks();
    if (next() == end) return true;
    if (!take(',')) return false;
    skip_blanks();
    return next() != end;
  }

  bool string() {
    const std::size_t first = ++at_;
    for (;;) {
      const auto c = static_cast<unsigned char>(next());
      if (c == '"') break;
      if (c < 0x20 || c == '\\') return false;
      const std::size_t bytes = c < 0x80 ? 1 : base::utf8_length(text_.substr(at_));
      if (bytes == 0) return false;
      at_ += bytes;
    }
    string_.assign(text_.substr(first, at_++ - first));
    return true;
  }

  std::size_t digits() {
    const std::size_t first = at_;
    while (next() >= '0' && next() <= '9') ++at_;
    return at_ - first;
  }

  bool number() {
    constexpr std::size_t kMostDigits = 18;  // they fit in both kinds of integers
    const std::size_t first = at_;
    const bool negative = take('-'), zero = next() == '0';
    const std::size_t whole = digits();
    if (whole == 0 || (zero && whole > 1)) return false;
    bool integer = true;
    if (take('.')) {
      integer = false;
      if (digits() == 0) return false;
    }
    if (take('e') || take('E')) {
      integer = false;
      if (!take('+')) (void)take('-');
      if (digits() == 0) return false;
    }
    const std::string_view token = text_.substr(first, at_ - first);
    if (!integer) {
      const auto value = base::parse_double(token);
      return value && events_.number_float(*value, {});
    }
    if (whole > kMostDigits) return false;
    const std::int64_t value = base::parse_int(token).value_or(0);
    return negative ? events_.number_integer(value) : events_.number_unsigned(static_cast<std::uint64_t>(value));
  }

  std::string_view text_;
  Events& events_;
  std::size_t at_ = 0;
  std::string string_;  // the last one
};

template <class Events>
bool scan_json(std::string_view text, Events& events) {
  return JsonScan<Events>(text, events).all();
}

}  // namespace coaster::exchange
