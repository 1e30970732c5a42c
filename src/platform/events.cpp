#include "platform/events.h"

#include <utility>

#include "base/words.h"

namespace coaster::platform {
namespace {

// The first name of a key is the one that is printed.
constexpr std::pair<std::string_view, Key> kNames[] = {
#define X(key, code, name) {name, Key::key},
    COASTER_KEYS(X)
#undef X
        {"Esc", Key::escape},
    {"Return", Key::enter},
    {"Del", Key::del}};

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

std::optional<Chord> parse_chord(std::string_view text) {
  Chord chord;
  std::string rest = base::lower(text);
  for (;;) {
    const std::size_t plus = rest.find('+');
    if (plus == std::string::npos || plus == 0) break;
    const std::string modifier = rest.substr(0, plus);
    if (modifier == "ctrl" || modifier == "control") chord.modifiers.ctrl = true;
    else if (modifier == "shift") chord.modifiers.shift = true;
    else if (modifier == "alt") chord.modifiers.alt = true;
    else return std::nullopt;
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
