// Input as plain data, the same from a window, a script and a recording. The event list of a frame contains all of its
// input.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace coaster::platform {

// Keys by what is printed on them (key_at()), named as on a US layout. X(enumerator, code, name): GLFW's
// codes, which are ASCII for printable keys.
// clang-format off
#define COASTER_KEYS(X) \
  X(space, 32, "Space") X(apostrophe, 39, "'") X(comma, 44, ",") X(minus, 45, "-") X(period, 46, ".") \
  X(slash, 47, "/") X(d0, 48, "0") X(d1, 49, "1") X(d2, 50, "2") X(d3, 51, "3") X(d4, 52, "4") X(d5, 53, "5") \
  X(d6, 54, "6") X(d7, 55, "7") X(d8, 56, "8") X(d9, 57, "9") X(semicolon, 59, ";") X(equal, 61, "=") X(a, 65, "A") \
  X(b, 66, "B") X(c, 67, "C") X(d, 68, "D") X(e, 69, "E") X(f, 70, "F") X(g, 71, "G") X(h, 72, "H") X(i, 73, "I") \
  X(j, 74, "J") X(k, 75, "K") X(l, 76, "L") X(m, 77, "M") X(n, 78, "N") X(o, 79, "O") X(p, 80, "P") X(q, 81, "Q") \
  X(r, 82, "R") X(s, 83, "S") X(t, 84, "T") X(u, 85, "U") X(v, 86, "V") X(w, 87, "W") X(x, 88, "X") X(y, 89, "Y") \
  X(z, 90, "Z") X(left_bracket, 91, "[") X(backslash, 92, "\\") X(right_bracket, 93, "]") X(grave, 96, "`") \
  X(escape, 256, "Escape") X(enter, 257, "Enter") X(tab, 258, "Tab") X(backspace, 259, "Backspace") \
  X(insert, 260, "Insert") X(del, 261, "Delete") X(right, 262, "Right") X(left, 263, "Left") X(down, 264, "Down") \
  X(up, 265, "Up") X(page_up, 266, "PageUp") X(page_down, 267, "PageDown") X(home, 268, "Home") X(end, 269, "End") \
  X(f1, 290, "F1") X(f2, 291, "F2") X(f3, 292, "F3") X(f4, 293, "F4") X(f5, 294, "F5") X(f6, 295, "F6") \
  X(f7, 296, "F7") X(f8, 297, "F8") X(f9, 298, "F9") X(f10, 299, "F10") X(f11, 300, "F11") X(f12, 301, "F12") \
  X(keypad_1, 321, "Keypad1") X(keypad_3, 323, "Keypad3") X(keypad_5, 325, "Keypad5") X(keypad_7, 327, "Keypad7") \
  X(keypad_enter, 335, "KeypadEnter")
// clang-format on
enum class Key : int {
  unknown = 0,
#define X(key, code, name) key = (code),
  COASTER_KEYS(X)
#undef X
};
// Returns a key's name in scripts and settings; empty for codes that are not keys.
std::string_view name_of(Key key);
std::vector<std::string> key_names();  // of all keys

struct Modifiers {
  bool shift = false, ctrl = false, alt = false;
  friend bool operator==(const Modifiers&, const Modifiers&) = default;
};

enum class Button : std::uint8_t { left, right, middle };

// How far the mouse moves before a press becomes a drag.
inline constexpr float kDragThreshold = 3;  // points; less is a click

struct MouseMove {
  float x = 0, y = 0;
  bool finger = false;  // on a touch screen, until a move without it
};                      // window pixels, origin top left
struct MouseButton {
  Button button = Button::left;
  bool down = true;
  Modifiers modifiers;
};
struct Wheel {
  float dx = 0, dy = 0;
};  // notches
struct KeyPress {
  Key key = Key::unknown;
  bool down = true;
  bool repeat = false;
  Modifiers modifiers;
  Key place =
      Key::unknown;  // on a US layout, also without a name; unknown for presses without a keyboard, as by scripts
};
struct TextInput {
  std::string utf8;
};
struct FileDrop {
  std::string path;
};  // a file dropped on the window
struct Resize {
  int width = 0, height = 0;
};  // framebuffer pixels; 0 when minimised
struct Focus {
  bool focused = true;
};
struct Expose {};  // the window system lost the picture
struct CloseRequest {};
// A gamepad in Xbox layout; sent if anything changed. Sticks -1..1, right and down positive; triggers 0 (released) to
// 1. Raw values, without dead zone.
struct GamepadAxes {
  float left_x = 0, left_y = 0, right_x = 0, right_y = 0, left_trigger = 0, right_trigger = 0;
  friend bool operator==(const GamepadAxes&, const GamepadAxes&) = default;
};
enum class PadButton : std::uint8_t { a, b, x, y };
inline constexpr std::array<std::string_view, 4> kPadButtonNames{"a", "b", "x",
                                                                 "y"};  // in the order of PadButton, for scripts
struct GamepadButton {
  PadButton button = PadButton::a;
  bool down = true;
};
struct Tick {
  double dt = 0;
};  // the last event of each poll: seconds since the previous one

using Event = std::variant<MouseMove, MouseButton, Wheel, KeyPress, TextInput, FileDrop, Resize, Focus, Expose,
                           CloseRequest, GamepadAxes, GamepadButton, Tick>;
using Events = std::vector<Event>;

// "F", "Escape", "Ctrl+Z", "Ctrl+Shift+S", "Space", "Delete", "F12"; case-insensitive; nothing for unknown names.
struct KeyChord {
  Key key = Key::unknown;
  Modifiers modifiers;
  friend bool operator==(const KeyChord&, const KeyChord&) = default;
};
std::optional<KeyChord> parse_chord(std::string_view text);
std::string to_text(const KeyChord& chord);

// Returns the key at a place of the US layout that types `print` without modifiers (UTF-8; "" if nothing or a dead
// key); Key::unknown if it has no name. A Latin letter is the printed one. The row of digits has the digits, also where
// they need Shift. Other keys are the printed ones, or have their place if the US layout has no key for what is
// printed. In a layout of another script all letters have their US places.
Key key_at(Key place, std::string_view print, bool other_script);

// True if a character is no Latin letter and no symbol. If a key at a letter's place types it, the layout is of another
// script: Cyrillic, Greek, Hebrew.
bool is_other_script(std::string_view print);

}  // namespace coaster::platform
