#include "platform/events.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <utility>

#include "base/words.h"

namespace coaster::platform {
namespace {

// Names besides letters and digits, which name themselves. The first name of a key is the one that is printed.
constexpr std::pair<std::string_view, Key> kNames[] = {
    {"space", Key::space},   {"'", Key::apostrophe},    {",", Key::comma},
    {"-", Key::minus},       {".", Key::period},        {"/", Key::slash},
    {";", Key::semicolon},   {"=", Key::equal},         {"[", Key::left_bracket},
    {"\\", Key::backslash},  {"]", Key::right_bracket}, {"`", Key::grave},
    {"escape", Key::escape}, {"esc", Key::escape},      {"enter", Key::enter},
    {"return", Key::enter},  {"tab", Key::tab},         {"backspace", Key::backspace},
    {"insert", Key::insert}, {"delete", Key::del},      {"del", Key::del},
    {"right", Key::right},   {"left", Key::left},       {"down", Key::down},
    {"up", Key::up},         {"pageup", Key::page_up},  {"pagedown", Key::page_down},
    {"home", Key::home},     {"end", Key::end},         {"f1", Key::f1},
    {"f2", Key::f2},         {"f3", Key::f3},           {"f4", Key::f4},
    {"f5", Key::f5},         {"f6", Key::f6},           {"f7", Key::f7},
    {"f8", Key::f8},         {"f9", Key::f9},           {"f10", Key::f10},
    {"f11", Key::f11},       {"f12", Key::f12},         {"keypadenter", Key::keypad_enter}};

Key key_named(const std::string& name) {
  if (name.size() == 1 && std::isalnum(static_cast<unsigned char>(name[0])))
    return static_cast<Key>(std::toupper(static_cast<unsigned char>(name[0])));
  for (const auto& [known, key] : kNames)
    if (known == name) return key;
  return Key::unknown;
}

}  // namespace

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
  const int code = static_cast<int>(chord.key);
  if (code < 128 && std::isalnum(code)) return out + static_cast<char>(code);
  for (const auto& [name, key] : kNames)
    if (key == chord.key) {
      std::string shown(name);
      shown[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(shown[0])));
      if (shown == "Pageup") shown = "PageUp";
      if (shown == "Pagedown") shown = "PageDown";
      if (shown == "Keypadenter") shown = "KeypadEnter";
      return out + shown;
    }
  return out + "?";
}

}  // namespace coaster::platform
