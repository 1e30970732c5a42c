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

std::optional<Chord> parse_chord(std::string_view text) {
  Chord chord;
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

std::string to_text(const Chord& chord) {
  std::string out;
  if (chord.modifiers.ctrl) out += "Ctrl+";
  if (chord.modifiers.shift) out += "Shift+";
  if (chord.modifiers.alt) out += "Alt+";
  const std::string_view name = name_of(chord.key);
  return out.append(name.empty() ? "?" : name);
}

}  // namespace coaster::platform
