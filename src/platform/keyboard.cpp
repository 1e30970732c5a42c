#include "platform/keyboard.h"

namespace coaster::platform {
namespace {

bool is_between(Key key, Key first, Key last) { return key >= first && key <= last; }
Key named(Key key) { return name_of(key).empty() ? Key::unknown : key; }

}  // namespace

Key key_at(Key place, std::string_view print, bool other_script) {
  constexpr Key kLastTyping{255};  // keys above it type nothing, or belong to the keypad
  if (place > kLastTyping || place == Key::space || is_between(place, Key::d0, Key::d9)) return named(place);
  const bool at_letter = is_between(place, Key::a, Key::z);
  if (print == "\u0131") return Key::i;  // the Turkish key of I
  if (print.size() == 1) {
    const char c = print.front();
    if (c >= 'a' && c <= 'z') return Key{c & ~32};
    if (!(other_script && at_letter) && !name_of(Key{c}).empty()) return Key{c};
  }
  return (at_letter ? other_script : !print.empty()) ? named(place) : Key::unknown;
}

bool is_other_script(std::string_view print) {
  // By the first bytes of UTF-8. Latin: up to U+036F and U+1E00 to U+1EFF; symbols: U+2000 to U+2BFF.
  const auto byte = [&](std::size_t i) { return i < print.size() ? static_cast<unsigned char>(print[i]) : 0U; };
  return byte(0) >= 0xcd && !(byte(0) == 0xe1 && byte(1) >= 0xb8 && byte(1) <= 0xbb) &&
         !(byte(0) == 0xe2 && byte(1) <= 0xaf);
}

}  // namespace coaster::platform
