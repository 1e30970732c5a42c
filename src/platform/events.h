// Input as plain data, the same from a window, a script and a recording. Everything that happens to a frame is in its
// event list.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace coaster::platform {

// Keys by their meaning on a US layout. Values of letters and digits are their ASCII codes.
enum class Key : int {
  unknown = 0,
  space = 32,
  apostrophe = 39,
  comma = 44,
  minus = 45,
  period = 46,
  slash = 47,
  d0 = 48,
  d1,
  d2,
  d3,
  d4,
  d5,
  d6,
  d7,
  d8,
  d9,
  semicolon = 59,
  equal = 61,
  a = 65,
  b,
  c,
  d,
  e,
  f,
  g,
  h,
  i,
  j,
  k,
  l,
  m,
  n,
  o,
  p,
  q,
  r,
  s,
  t,
  u,
  v,
  w,
  x,
  y,
  z,
  left_bracket = 91,
  backslash = 92,
  right_bracket = 93,
  grave = 96,
  escape = 256,
  enter,
  tab,
  backspace,
  insert,
  del,
  right,
  left,
  down,
  up,
  page_up,
  page_down,
  home,
  end,
  f1 = 290,
  f2,
  f3,
  f4,
  f5,
  f6,
  f7,
  f8,
  f9,
  f10,
  f11,
  f12,
  keypad_enter = 335
};

struct Modifiers {
  bool shift = false, ctrl = false, alt = false;
  friend bool operator==(const Modifiers&, const Modifiers&) = default;
};

enum class Button : std::uint8_t { left, right, middle };

struct MouseMove {
  float x = 0, y = 0;
};  // window pixels, origin top left
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
};
struct TextInput {
  std::string utf8;
};
struct Drop {
  std::string path;
};  // a file dropped on the window
struct Resize {
  int width = 0, height = 0;
};  // framebuffer pixels; 0 when minimised
struct Focus {
  bool focused = true;
};
struct CloseRequest {};
// A gamepad in Xbox layout; sent if anything changed. Sticks -1..1, right and down positive; triggers 0 (released) to
// 1. Raw values, without dead zone.
struct GamepadAxes {
  float left_x = 0, left_y = 0, right_x = 0, right_y = 0, left_trigger = 0, right_trigger = 0;
  friend bool operator==(const GamepadAxes&, const GamepadAxes&) = default;
};
enum class PadButton : std::uint8_t { a, b, x, y };
inline constexpr std::array<std::string_view, 4> kPadButtonNames{"a", "b", "x", "y"};  // by PadButton, for scripts
struct GamepadButton {
  PadButton button = PadButton::a;
  bool down = true;
};
struct Tick {
  double dt = 0;
};  // the last event of each poll: seconds since the previous one

using Event = std::variant<MouseMove, MouseButton, Wheel, KeyPress, TextInput, Drop, Resize, Focus, CloseRequest,
                           GamepadAxes, GamepadButton, Tick>;
using Events = std::vector<Event>;

// "F", "Escape", "Ctrl+Z", "Ctrl+Shift+S", "Space", "Delete", "F12"; case-insensitive; nothing for unknown names.
struct Chord {
  Key key = Key::unknown;
  Modifiers modifiers;
  friend bool operator==(const Chord&, const Chord&) = default;
};
std::optional<Chord> parse_chord(std::string_view text);
std::string to_text(const Chord& chord);

}  // namespace coaster::platform
