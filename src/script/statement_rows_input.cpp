// The rows of input, and their readers: widgets, targets in the viewport, keys, gamepads, single events.
#include <algorithm>
#include <array>
#include <tuple>
#include <utility>

#include <fmt/format.h>

#include "script/statement_rows.h"

namespace coaster::script {
namespace {

using view::PickKind;
using AimVerb = AimAction::Verb;
using UiVerb = UiAction::Verb;

// Reads a widget's path and what `more` reads; the verbs of a row follow each other.
template <UiVerb verb, bool (*more)(WordReader&, UiAction&)>
bool read_ui(WordReader& words, std::size_t which, Action& action) {
  UiAction ui{.verb = static_cast<UiVerb>(static_cast<std::size_t>(verb) + which)};
  if (!take(words, "a widget's path such as \"Track/Insert point\"", ui.path)) return false;
  if (ui.path.text.empty()) return words.fail(ui.path.column, "expected a widget's path, found \"\"");
  if (!more(words, ui)) return false;
  action = std::move(ui);
  return words.end();
}

bool read_path_alone(WordReader& words, UiAction&) { return end_of_text(words); }

bool read_check(WordReader& words, UiAction& ui) {
  const auto on = words.at_end() ? std::optional(true) : words.on_off();
  ui.on = on.value_or(true);
  return on.has_value();
}

bool read_typed(WordReader& words, UiAction& ui) {
  return take(words, "the text to type", ui.text) && end_of_text(words);
}

bool read_slide(WordReader& words, UiAction& ui) {
  if (words.accept("to")) {
    ui.verb = UiVerb::drag_to;
    base::Token value;
    if (!take(words, "a value", value)) return false;
    ui.text = value.text;
    return base::parse_double(value.text) ||
           words.fail(value.column, "expected a number, found " + base::quoted_start(value.text));
  }
  words.accept("by");
  if (!number(words, "a distance in pixels", ui.number)) return false;
  words.accept("px");
  return true;
}

bool read_scroll(WordReader& words, UiAction& ui) {
  words.accept("by");
  return number(words, "notches of the wheel (positive: down)", ui.number);
}

void take_modifiers(WordReader& words, platform::Modifiers& modifiers) {
  for (;;) {
    if (words.accept("+shift")) modifiers.shift = true;
    else if (words.accept("+ctrl")) modifiers.ctrl = true;
    else if (words.accept("+alt")) modifiers.alt = true;
    else return;
  }
}

constexpr std::string_view kTargets =
    "@k3, @k3.in, @k3.out, @k3.spin, @s2:0.4, @c1, @q2, @q2.turn, @q2.bank, gizmo.x .. gizmo.xy, ground X Y Z or world "
    "X Y Z";

bool refuse(WordReader& words, const base::Token& word) {
  const std::string at = "@" + word.text.substr(0, word.text.find_first_of(".:"));
  const std::string hint = world::parse_name(at.substr(1)) ? fmt::format("; did you mean \"@{}\"?", word.text) : "";
  return words.fail({word.column, fmt::format("expected {}, found {}{}", kTargets, base::quoted_start(word.text), hint),
                     false, true});
}

// Reads "@k3.in", "@s2:0.4" and so on.
bool read_entity(WordReader& words, const base::Token& word, AimPoint& point) {
  using world::EntityKind;
  constexpr std::tuple<EntityKind, std::string_view, PickKind> kMarks[] = {
      {EntityKind::knot, "", PickKind::knot},          {EntityKind::knot, "in", PickKind::handle_in},
      {EntityKind::knot, "out", PickKind::handle_out}, {EntityKind::knot, "spin", PickKind::spin},
      {EntityKind::section, "", PickKind::section},    {EntityKind::section, "turn", PickKind::turn},
      {EntityKind::section, "bank", PickKind::bank},   {EntityKind::cart, "", PickKind::cart}};
  std::string_view text = word.text;
  if (!text.starts_with('@') || text.ends_with(':')) return refuse(words, word);
  text.remove_prefix(1);
  const std::size_t mark_at = text.find_first_of(text.find(':') == std::string_view::npos ? "." : ":");
  const bool marked = mark_at != std::string_view::npos;
  const std::string_view rest = marked ? text.substr(mark_at + 1) : std::string_view();
  const auto name = world::parse_name(text.substr(0, mark_at));
  if (!name) return refuse(words, word);
  point.name = *name;
  const bool placed = marked && text[mark_at] == ':';
  for (const auto& [of, mark, kind] : kMarks)
    if (of == name->kind && !placed && rest == mark) return point.kind = kind, true;
  if (name->kind != EntityKind::segment || (!placed && !rest.empty())) return refuse(words, word);
  point.kind = PickKind::curve;
  const auto t = placed ? base::parse_double(rest) : std::optional(0.5);
  point.t = t.value_or(0);
  return (t && *t >= 0 && *t <= 1) ||
         words.fail({word.column, "expected a parameter from 0 to 1 after the colon, found " + base::quoted_start(rest),
                     base::is_number(rest)});
}

// Reads "gizmo.x", an arrow, and "gizmo.xz", the square that moves along both axes.
bool read_gizmo(WordReader& words, const base::Token& word, AimPoint& point) {
  constexpr std::array<std::string_view, 6> kParts{"x", "y", "z", "yz", "xz", "xy"};
  const auto part =
      std::find(kParts.begin(), kParts.end(), std::string_view(word.text).substr(std::string_view("gizmo.").size()));
  if (part == kParts.end()) return refuse(words, word);
  point.kind = static_cast<PickKind>(static_cast<int>(PickKind::axis_x) + (part - kParts.begin()));
  return true;
}

bool read_target(WordReader& words, base::Token& word, AimPoint& point) {
  if (!take(words, kTargets, word)) return false;
  if (word.text.starts_with("gizmo.")) return read_gizmo(words, word, point);
  if (word.text != "ground" && word.text != "world") return read_entity(words, word, point);
  const auto position = words.vector("a coordinate (m)");
  if (position) point.position = *position;
  point.on_ground = word.text == "ground";
  return position.has_value();
}

// Reads "to X Y Z", "to TARGET" or "by X Y Z".
bool read_aim_drag(WordReader& words, AimAction& aim) {
  if (words.accept("by")) {
    aim.by = words.vector("a distance (m)");
    return aim.by.has_value();
  }
  if (!words.accept("to")) return words.fail(next_column(words), "expected by X Y Z or to TARGET");
  AimPoint& to = aim.to.emplace();
  base::Token target;
  if (words.at_end() || !base::parse_double(words.peek()->text)) return read_target(words, target, to);
  const auto position = words.vector("a coordinate (m)");
  to.position = position.value_or(to.position);
  return position.has_value();
}

// Reads the target, with modifiers before and after it and at the end. The verbs of a row follow each other.
template <AimVerb verb>
bool read_aim(WordReader& words, std::size_t which, Action& action) {
  AimAction aim{.verb = static_cast<AimVerb>(static_cast<std::size_t>(verb) + which)};
  take_modifiers(words, aim.modifiers);
  base::Token target;
  if (!read_target(words, target, aim.target)) return false;
  aim.target_text = target.text, aim.target_column = target.column;
  take_modifiers(words, aim.modifiers);
  if (verb == AimVerb::drag) {
    if (!read_aim_drag(words, aim)) return false;
    take_modifiers(words, aim.modifiers);
  }
  action = std::move(aim);
  return words.end();
}

// Returns what the message about an unknown key ends with: the same and the words behind it joined by plus signs, else
// the nearest key, else which keys may come before it.
std::string near_chord(const std::string& text, std::span<const base::Token> more) {
  std::string joined = text;
  for (const base::Token& word : more) joined += "+" + word.text;
  std::replace(joined.begin(), joined.end(), '-', '+');
  if (const auto chord = platform::parse_chord(joined))
    return fmt::format("; did you mean {}?", base::quoted_start(to_text(*chord)));
  const std::string key = text.substr(text.rfind('+') + 1);
  if (platform::parse_chord(key)) return "; only Ctrl, Shift and Alt can come before a key";
  return base::suggestion(key, platform::key_names());
}

std::optional<platform::KeyChord> take_chord(WordReader& words) {
  const base::Token* const word = words.take("a key such as F or Ctrl+Z");
  if (!word) return std::nullopt;
  const auto chord = platform::parse_chord(word->text);
  if (!chord)
    words.fail(word->column, fmt::format("expected a key such as F, Escape, Left or Ctrl+Z, found {}{}",
                                         base::quoted_start(word->text), near_chord(word->text, words.rest())));
  return chord;
}

bool read_key(WordReader& words, Input& input) {
  const auto chord = take_chord(words);
  if (!chord) return false;
  input = {{{platform::KeyPress{chord->key, true, false, chord->modifiers}},
            {platform::KeyPress{chord->key, false, false, {}}}},
           true};
  return true;
}

bool read_text(WordReader& words, Input& input) {
  platform::TextInput typed;
  if (!take(words, "a text", typed.utf8)) return false;
  input.steps.push_back({std::move(typed)});
  return end_of_text(words);
}

bool read_move(WordReader& words, Input& input) {
  platform::MouseMove to;
  input.steps.push_back({to});
  if (!number(words, "x in pixels", to.x) || !number(words, "y in pixels", to.y)) return false;
  input.steps.back() = {to};
  return true;
}

bool read_wheel(WordReader& words, Input& input) {
  platform::Wheel wheel;
  if (!number(words, "notches of the wheel", wheel.dy)) return false;
  if (words.accept("at") && !read_move(words, input)) return false;
  input.steps.push_back({wheel});
  return true;
}

// Reads a file, or knots to lower to the ground: the command of that name.
bool read_drop(WordReader& words, std::size_t, Action& action) {
  if (const base::Token* const first = words.peek();
      first && !first->quoted && (first->text.starts_with('@') || first->text == "all" || first->text == "selected"))
    return read_command("drop", words.rest(), words, action);
  platform::FileDrop drop;
  if (!take(words, "a file", drop.path)) return false;
  action = Input{{{std::move(drop)}}};
  return end_of_text(words);
}

// Reads "left 0 0.5 right 0 0 triggers 0 1", which releases everything that is not named, and "a", which presses and
// releases.
bool read_pad(WordReader& words, Input& input) {
  static const std::vector<std::string> kNames = [] {
    std::vector<std::string> names{"left", "right", "triggers", "rest"};
    for (const std::string_view name : platform::kPadButtonNames) names.emplace_back(name);
    return names;
  }();
  constexpr std::size_t kButtons = 4;
  if (words.at_end()) return words.fail(words.end_column(), "expected " + base::alternatives(kNames));
  platform::GamepadAxes axes;
  const auto stick = [&](float& x, float& y) {
    constexpr std::string_view kWhat = "a stick's position, -1 to 1";
    return number_within(words, kWhat, -1, 1, x) && number_within(words, kWhat, -1, 1, y);
  };
  const auto trigger = [&](float& to) { return number_within(words, "a trigger, 0 to 1", 0, 1, to); };
  while (!words.at_end()) {
    const auto name = choice(words, kNames);
    if (!name) return false;
    if (*name >= kButtons) {
      const auto button = static_cast<platform::PadButton>(*name - kButtons);
      input = {{{platform::GamepadButton{button, true}}, {platform::GamepadButton{button, false}}}, true};
      return true;
    }
    if (*name == 0 && !stick(axes.left_x, axes.left_y)) return false;
    if (*name == 1 && !stick(axes.right_x, axes.right_y)) return false;
    if (*name == 2 && !(trigger(axes.left_trigger) && trigger(axes.right_trigger))) return false;
  }
  input.steps.push_back({axes});
  return true;
}

bool read_focus(WordReader& words, Input& input) {
  const auto on = words.at_end() ? std::optional(true) : words.on_off();
  input.steps.push_back({platform::Focus{on.value_or(true)}});
  return on.has_value();
}

bool read_resize(WordReader& words, Input& input) {
  base::Token word;
  if (!take(words, "WIDTHxHEIGHT", word)) return false;
  if (!words.at_end() && word.text.find_first_of("xX") == std::string::npos)
    word.text += "x" + words.take("a height")->text;
  platform::Resize size;
  if (!base::parse_size(word.text, size.width, size.height))
    return words.fail(base::size_error(word.column, word.text));
  input.steps.push_back({size});
  return true;
}

bool read_minimise(WordReader&, Input& input) {
  input.steps.push_back({platform::Resize{0, 0}});
  return true;
}

bool read_button(WordReader& words, std::size_t which, Action& action) {
  static const std::vector<std::string> kButtons{"left", "right", "middle"};
  const auto button = words.at_end() ? std::optional<std::size_t>(0) : choice(words, kButtons);
  if (!button) return false;
  platform::MouseButton event{static_cast<platform::Button>(*button), which == 0, {}};
  take_modifiers(words, event.modifiers);
  action = Input{{{event}}};
  return words.end();
}

bool read_raw_key(WordReader& words, Input& input) {
  static const std::vector<std::string> kWays{"down", "up"};
  const auto chord = take_chord(words);
  const auto way = chord ? choice(words, kWays) : std::nullopt;
  if (!way) return false;
  const bool down = *way == 0;
  input.steps.push_back({platform::KeyPress{chord->key, down, false, down ? chord->modifiers : platform::Modifiers{}}});
  return true;
}

constexpr StatementRow kInputRows[]{
    {"ui.click|doubleclick|hover \"PATH\"", "Clicks or hovers the widget with this label path.",
     read_ui<UiVerb::click, read_path_alone>},
    {"ui.check \"PATH\" [on|off]", "Clicks if the box is in the other state.", read_ui<UiVerb::check, read_check>},
    {"ui.type \"PATH\" \"TEXT\"", "Replaces a field's text and presses Enter.", read_ui<UiVerb::type, read_typed>},
    {"ui.drag \"PATH\" by N px", "Drags sideways from the widget's middle.", read_ui<UiVerb::drag_by, read_slide>},
    {"ui.drag \"PATH\" to VALUE", "Drags a slider until it shows the value."},
    {"ui.open|close \"PATH\"", "Opens or closes a header; opens a combo or menu.",
     read_ui<UiVerb::open, read_path_alone>},
    {"ui.menu \"MENU/ITEM\"", "Opens the menu and clicks the item.", read_ui<UiVerb::menu, read_path_alone>},
    {"ui.scroll \"PANEL\" N", "Turns the wheel over a panel; positive scrolls down.",
     read_ui<UiVerb::scroll, read_scroll>},
    {"aim.click|doubleclick|hover [+shift] [+ctrl] [+alt] TARGET",
     "TARGET: @k3 @k3.in @k3.out @k3.spin @s2:0.4 @c1 @q2 @q2.turn @q2.bank gizmo.x gizmo.xz, ground X Y Z, world X "
     "Y Z.",
     read_aim<AimVerb::click>},
    {"aim.drag [+shift] [+ctrl] [+alt] TARGET by X Y Z",
     "Presses, moves by an offset (m) and releases in the viewport.", read_aim<AimVerb::drag>},
    {"aim.drag [+shift] [+ctrl] [+alt] TARGET to X Y Z|TARGET", "The same, to a position."},
    {"key CHORD", "Presses and releases a key: F, Escape, Ctrl+Z.", reads<read_key>},
    {"text|raw.text \"TEXT\"", "Types a text.", reads<read_text>},
    {"wheel|raw.wheel N [at X Y]", "Turns the wheel; positive turns up.", reads<read_wheel>},
    {"drop \"FILE\"", "Drops a file on the window.", read_drop},
    {"pad [left X Y] [right X Y] [triggers L R]",
     "Holds a gamepad's sticks (-1..1, right and down positive) and triggers (0..1); releases those that are not "
     "named.",
     reads<read_pad>},
    {"pad rest | a | b | x | y", "Releases everything, or presses and releases a button."},
    {"focus [on|off]", "Gives the window keyboard focus or takes it away.", reads<read_focus>},
    {"resize WxH", "Changes the picture's size.", reads<read_resize>},
    {"minimise|minimize", "Minimises the window: size 0, nothing is drawn.", reads<read_minimise>},
    {"raw.move X Y", "Moves the cursor to a pixel.", reads<read_move>},
    {"raw.press|release [left|right|middle] [+shift] [+ctrl] [+alt]", "Presses or releases a button.", read_button},
    {"raw.key CHORD down|up", "Presses or releases a key.", reads<read_raw_key>},
};

}  // namespace

std::span<const StatementRow> input_rows() { return kInputRows; }

}  // namespace coaster::script
