// Parses input: keys, text, wheel, dropped files, focus, size, and raw events.
#include "script/lines.h"

#include <algorithm>

#include <fmt/format.h>

namespace coaster::script {
namespace {

bool finish(Words& words, Action& action, Input input) {
  action = std::move(input);
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

std::optional<platform::Chord> take_chord(Words& words) {
  const base::Token* const word = words.take("a key such as F or Ctrl+Z");
  if (!word) return std::nullopt;
  const auto chord = platform::parse_chord(word->text);
  if (!chord)
    words.fail(word->column, fmt::format("expected a key such as F, Escape, Left or Ctrl+Z, found {}{}",
                                         base::quoted_start(word->text), near_chord(word->text, words.rest())));
  return chord;
}

std::optional<platform::Button> take_button(Words& words) {
  static const std::vector<std::string> kButtons{"left", "right", "middle"};
  if (words.at_end()) return platform::Button::left;
  const auto button = words.one_of("left, right or middle", kButtons);
  if (!button) return std::nullopt;
  return static_cast<platform::Button>(*button);
}

template <bool down>
bool parse_raw_button(Words& words, Action& action) {
  const auto button = take_button(words);
  if (!button) return false;
  platform::Modifiers modifiers;
  take_modifiers(words, modifiers);
  return finish(words, action, {{{platform::MouseButton{*button, down, modifiers}}}});
}

bool parse_key(Words& words, Action& action) {
  const auto chord = take_chord(words);
  if (!chord) return false;
  Input input;
  input.steps.push_back({platform::KeyPress{chord->key, true, false, chord->modifiers}});
  input.steps.push_back({platform::KeyPress{chord->key, false, false, {}}});
  input.last_step_can_wait = true;
  return finish(words, action, std::move(input));
}

bool parse_text(Words& words, Action& action) {
  const base::Token* const text = words.take("a text");
  if (!text) return false;
  action = Input{{{platform::TextInput{text->text}}}};
  return end_of_text(words);
}

bool parse_wheel(Words& words, Action& action) {
  const auto notches = words.number("notches of the wheel");
  if (!notches) return false;
  Input input;
  if (words.accept("at")) {
    const auto x = words.number("x in pixels"), y = words.number("y in pixels");
    if (!x || !y) return false;
    input.steps.push_back({platform::MouseMove{static_cast<float>(*x), static_cast<float>(*y)}});
  }
  input.steps.push_back({platform::Wheel{0, static_cast<float>(*notches)}});
  return finish(words, action, std::move(input));
}

// Parses a file, or knots to lower to the ground: the command of that name.
bool parse_drop(Words& words, Action& action) {
  if (const base::Token* const first = words.peek();
      first && !first->quoted && (first->text.starts_with('@') || first->text == "all" || first->text == "selected"))
    return parse_command("drop", words.rest(), words, action);
  const base::Token* const path = words.take("a file");
  if (!path) return false;
  action = Input{{{platform::Drop{path->text}}}};
  return end_of_text(words);
}

// Parses "pad left 0 0.5 right 0 0 triggers 0 1", which releases everything that is not named, and "pad a", which
// presses and releases.
bool parse_pad(Words& words, Action& action) {
  static const std::vector<std::string> kNames = [] {
    std::vector<std::string> names{"left", "right", "triggers", "rest"};
    for (const std::string_view name : platform::kPadButtonNames) names.emplace_back(name);
    return names;
  }();
  constexpr const char* kWanted = "left, right, triggers, rest, a, b, x or y";
  constexpr std::size_t kButtons = 4;
  if (words.at_end()) return words.fail(words.end_column(), fmt::format("expected {}", kWanted));
  platform::GamepadAxes axes;
  const auto within = [&](const char* what, double low) -> std::optional<float> {
    const auto value = words.number(what);
    if (!value) return std::nullopt;
    if (!(*value >= low && *value <= 1)) {
      words.reject_number(what);
      return std::nullopt;
    }
    return static_cast<float>(*value);
  };
  while (!words.at_end()) {
    const auto name = words.one_of(kWanted, kNames);
    if (!name) return false;
    if (*name >= kButtons) {
      const auto button = static_cast<platform::PadButton>(*name - kButtons);
      Input input{{{platform::GamepadButton{button, true}}, {platform::GamepadButton{button, false}}}, true};
      return finish(words, action, std::move(input));
    }
    if (*name == 3) continue;
    const bool triggers = *name == 2;
    const char* const what = triggers ? "a trigger, 0 to 1" : "a stick's position, -1 to 1";
    const auto first = within(what, triggers ? 0 : -1);
    const auto second = first ? within(what, triggers ? 0 : -1) : std::nullopt;
    if (!second) return false;
    if (*name == 0) axes.left_x = *first, axes.left_y = *second;
    else if (*name == 1) axes.right_x = *first, axes.right_y = *second;
    else axes.left_trigger = *first, axes.right_trigger = *second;
  }
  return finish(words, action, {{{axes}}});
}

bool parse_focus(Words& words, Action& action) {
  const auto on = words.at_end() ? std::optional<bool>(true) : words.on_off();
  if (!on) return false;
  return finish(words, action, {{{platform::Focus{*on}}}});
}

bool parse_resize(Words& words, Action& action) {
  const base::Token* const first = words.take("WIDTHxHEIGHT");
  if (!first) return false;
  std::string text = first->text;
  if (!words.at_end() && text.find_first_of("xX") == std::string::npos) text += "x" + words.take("a height")->text;
  platform::Resize size;
  if (!base::parse_size(text, size.width, size.height)) return words.fail(base::size_error(first->column, text));
  return finish(words, action, {{{size}}});
}

bool parse_minimise(Words& words, Action& action) { return finish(words, action, {{{platform::Resize{0, 0}}}}); }

bool parse_raw_move(Words& words, Action& action) {
  const auto x = words.number("x in pixels"), y = words.number("y in pixels");
  if (!x || !y) return false;
  return finish(words, action, {{{platform::MouseMove{static_cast<float>(*x), static_cast<float>(*y)}}}});
}

bool parse_raw_key(Words& words, Action& action) {
  static const std::vector<std::string> kWays{"down", "up"};
  const auto chord = take_chord(words);
  if (!chord) return false;
  const auto way = words.one_of("down or up", kWays);
  if (!way) return false;
  const bool down = *way == 0;
  return finish(words, action,
                {{{platform::KeyPress{chord->key, down, false, down ? chord->modifiers : platform::Modifiers{}}}}});
}

constexpr LineRow kInputLines[]{{"key", parse_key},
                                {"text", parse_text},
                                {"wheel", parse_wheel},
                                {"drop", parse_drop},
                                {"pad", parse_pad},
                                {"focus", parse_focus},
                                {"resize", parse_resize},
                                {"minimise", parse_minimise},
                                {"minimize", parse_minimise},
                                {"raw.move", parse_raw_move},
                                {"raw.press", parse_raw_button<true>},
                                {"raw.release", parse_raw_button<false>},
                                {"raw.key", parse_raw_key},
                                {"raw.wheel", parse_wheel},
                                {"raw.text", parse_text}};

}  // namespace

std::span<const LineRow> input_lines() { return kInputLines; }

void take_modifiers(Words& words, platform::Modifiers& modifiers) {
  for (;;) {
    if (words.accept("+shift")) modifiers.shift = true;
    else if (words.accept("+ctrl")) modifiers.ctrl = true;
    else if (words.accept("+alt")) modifiers.alt = true;
    else return;
  }
}

}  // namespace coaster::script
