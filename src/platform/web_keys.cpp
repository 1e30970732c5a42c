#include "platform/web_keys.h"

#include <cstdlib>
#include <cstring>
#include <string_view>

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

}  // namespace

Key key_of(const EmscriptenKeyboardEvent& event) {
  for (const NamedKey& named : kNamedKeys)
    if (std::strcmp(named.code, event.code) == 0) return named.key;
  const std::string_view code = event.code, typed = event.key;
  if (typed.size() == 1 && ((typed[0] | 32) >= 'a' && (typed[0] | 32) <= 'z')) return Key{typed[0] & ~32};
  if (code.starts_with("Digit")) return Key{code[5]};
  if (code.size() >= 2 && code[0] == 'F') {
    const int number = std::atoi(event.code + 1);
    if (number >= 1 && number <= 12) return Key{static_cast<int>(Key::f1) + number - 1};
  }
  return Key::unknown;
}

}  // namespace coaster::platform
