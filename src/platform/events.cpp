#include "platform/events.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "base/text.h"

namespace coaster::platform {
namespace {

// The first name of a key is the one that is printed. Others are those that people and browsers use, too.
constexpr std::pair<std::string_view, Key> kNames[] = {
#define X(key, code, name) {name, Key::key},
    COASTER_KEYS(X)
#undef X
        {"Esc", Key::escape},
    {"Return", Key::enter},
    {"Del", Key::del},
    {"Ins", Key::insert},
    {"PgUp", Key::page_up},
    {"PgDn", Key::page_down},
    {"ArrowLeft", Key::left},
    {"ArrowRight", Key::right},
    {"ArrowUp", Key::up},
    {"ArrowDown", Key::down}};

constexpr std::pair<std::string_view, bool Modifiers::*> kModifiers[] = {
    {"ctrl", &Modifiers::ctrl}, {"strg", &Modifiers::ctrl}, {"control", &Modifiers::ctrl},
    {"cmd", &Modifiers::ctrl},  {"meta", &Modifiers::ctrl}, {"shift", &Modifiers::shift},
    {"alt", &Modifiers::alt},   {"option", &Modifiers::alt}};

Key key_named(const std::string& lower_name) {
  for (const auto& [name, key] : kNames)
    if (base::lower(name) == lower_name) return key;
  return Key::unknown;
}

bool is_between(Key key, Key first, Key last) { return key >= first && key <= last; }
Key named(Key key) { return name_of(key).empty() ? Key::unknown : key; }

}  // namespace

std::string_view name_of(Key key) {
  for (const auto& [name, known] : kNames)
    if (known == key) return name;
  return {};
}

std::vector<std::string> key_names() {
  std::vector<std::string> names;
  for (const auto& [name, key] : kNames)
    if (name == name_of(key)) names.emplace_back(name);
  return names;
}

std::optional<KeyChord> parse_chord(std::string_view text) {
  KeyChord chord;
  std::string rest = base::lower(text);
  for (;;) {
    const std::size_t plus = rest.find('+');
    if (plus == std::string::npos || plus == 0) break;
    const auto held = std::find_if(std::begin(kModifiers), std::end(kModifiers),
                                   [&](const auto& row) { return row.first == rest.substr(0, plus); });
    if (held == std::end(kModifiers)) return std::nullopt;
    chord.modifiers.*held->second = true;
    rest.erase(0, plus + 1);
  }
  chord.key = key_named(rest);
  if (chord.key == Key::unknown) return std::nullopt;
  return chord;
}

std::string to_text(const KeyChord& chord) {
  std::string out;
  if (chord.modifiers.ctrl) out += "Ctrl+";
  if (chord.modifiers.shift) out += "Shift+";
  if (chord.modifiers.alt) out += "Alt+";
  const std::string_view name = name_of(chord.key);
  return out.append(name.empty() ? "?" : name);
}

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
