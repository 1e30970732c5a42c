#include "platform/web_keys.h"

#include <cstdlib>
#include <cstring>
#include <string_view>

#include "platform/keyboard.h"

namespace coaster::platform {
namespace {

struct NamedKey {
  const char* code;
  Key key;
};
// clang-format off
constexpr NamedKey kNamedKeys[] = {
    {"Space", Key::space}, {"Quote", Key::apostrophe}, {"Comma", Key::comma}, {"Minus", Key::minus},
    {"Period", Key::period}, {"Slash", Key::slash}, {"Semicolon", Key::semicolon}, {"Equal", Key::equal},
    {"BracketLeft", Key::left_bracket}, {"Backslash", Key::backslash}, {"BracketRight", Key::right_bracket},
    {"Backquote", Key::grave}, {"Escape", Key::escape}, {"Enter", Key::enter}, {"Tab", Key::tab},
    {"Backspace", Key::backspace}, {"Insert", Key::insert}, {"Delete", Key::del}, {"ArrowRight", Key::right},
    {"ArrowLeft", Key::left}, {"ArrowDown", Key::down}, {"ArrowUp", Key::up}, {"PageUp", Key::page_up},
    {"PageDown", Key::page_down}, {"Home", Key::home}, {"End", Key::end}, {"Numpad1", Key::keypad_1},
    {"Numpad3", Key::keypad_3}, {"Numpad5", Key::keypad_5}, {"Numpad7", Key::keypad_7},
    {"NumpadEnter", Key::keypad_enter}};
// clang-format on

// Returns the key's place on a US layout.
Key place_of(const EmscriptenKeyboardEvent& event) {
  for (const NamedKey& named : kNamedKeys)
    if (std::strcmp(named.code, event.code) == 0) return named.key;
  const std::string_view code = event.code;
  if (code.size() == 4 && code.starts_with("Key")) return Key{code[3]};
  if (code.size() == 6 && code.starts_with("Digit")) return Key{code[5]};
  if (code.size() >= 2 && code[0] == 'F') {
    const int number = std::atoi(event.code + 1);
    if (number >= 1 && number <= 12) return Key{static_cast<int>(Key::f1) + number - 1};
  }
  return Key{code.starts_with("Numpad") ? 320 : -1};  // one without a name, of the keypad or elsewhere
}

// Returns the character of the event, "" for keys with names of several letters.
std::string_view character_of(const EmscriptenKeyboardEvent& event) {
  const std::string_view typed = event.key;
  return typed.size() == 1 || (!typed.empty() && (typed[0] & 0x80) != 0) ? typed : "";
}

// True if Option makes another character than a letter or digit: @ on macOS.
bool is_option_text(std::string_view print, Modifiers held) {
  const auto is = [&](char first, char last) { return (print[0] | 32) >= first && (print[0] | 32) <= last; };
  return held.alt && !held.ctrl && !print.empty() && !is('a', 'z') && !is('0', '9');
}

}  // namespace

KeyPress WebKeyboard::read(const EmscriptenKeyboardEvent& event, bool down, Modifiers held) {
  if (std::strcmp(event.key, "AltGraph") == 0) alt_graph_ = down;
  const Key place = place_of(event);
  const std::string_view print = character_of(event);
  const bool text = (alt_graph_ && down) || is_option_text(print, held);
  if (place >= Key::a && place <= Key::z && !print.empty() && !text) other_script_ = is_other_script(print);
  return {text ? Key::unknown : key_at(place, print, other_script_), down, event.repeat != 0, held, place};
}

std::string WebKeyboard::text(const EmscriptenKeyboardEvent& event, Modifiers held) const {
  const std::string_view print = character_of(event);
  const bool shortcut = held.ctrl || (held.alt && !is_option_text(print, held));
  return std::string(shortcut && !alt_graph_ ? "" : print);
}

}  // namespace coaster::platform
