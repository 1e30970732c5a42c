// Parses ui.*: a widget's path and the action.
#include "script/lines.h"

namespace coaster::script {
namespace {

using UiVerb = UiAction::Verb;

std::optional<UiAction> take_path(Words& words, UiVerb verb) {
  UiAction ui{.verb = verb};
  if (!take(words, "a widget's path such as \"Track/Insert point\"", ui.path)) return std::nullopt;
  if (!ui.path.text.empty()) return ui;
  words.fail(ui.path.column, "expected a widget's path, found \"\"");
  return std::nullopt;
}

template <UiVerb verb>
bool path_alone(Words& words, Action& action) {
  auto ui = take_path(words, verb);
  if (ui) action = *std::move(ui);
  return end_of_text(words);
}

bool parse_ui_check(Words& words, Action& action) {
  auto ui = take_path(words, UiVerb::check);
  if (!ui) return false;
  if (!words.at_end()) {
    const auto on = words.on_off();
    if (!on) return false;
    ui->on = *on;
  }
  action = *std::move(ui);
  return words.end();
}

bool parse_ui_type(Words& words, Action& action) {
  auto ui = take_path(words, UiVerb::type);
  if (!ui) return false;
  const base::Token* const text = words.take("the text to type");
  if (!text) return false;
  ui->text = text->text;
  action = *std::move(ui);
  return end_of_text(words);
}

bool parse_ui_drag(Words& words, Action& action) {
  auto ui = take_path(words, UiVerb::drag_by);
  if (!ui) return false;
  if (words.accept("to")) {
    const base::Token* const value = words.take("a value");
    if (!value) return false;
    if (!base::parse_double(value->text))
      return words.fail(value->column, "expected a number, found " + base::quoted_start(value->text));
    ui->verb = UiVerb::drag_to;
    ui->text = value->text;
  } else {
    words.accept("by");
    const auto by = words.number("a distance in pixels");
    if (!by) return false;
    words.accept("px");
    ui->number = *by;
  }
  action = *std::move(ui);
  return words.end();
}

bool parse_ui_scroll(Words& words, Action& action) {
  auto ui = take_path(words, UiVerb::scroll);
  if (!ui) return false;
  words.accept("by");
  const auto notches = words.number("notches of the wheel (positive: down)");
  if (!notches) return false;
  ui->number = *notches;
  action = *std::move(ui);
  return words.end();
}

constexpr LineRow kUiLines[]{{"ui.click", path_alone<UiVerb::click>},
                             {"ui.doubleclick", path_alone<UiVerb::doubleclick>},
                             {"ui.hover", path_alone<UiVerb::hover>},
                             {"ui.check", parse_ui_check},
                             {"ui.type", parse_ui_type},
                             {"ui.drag", parse_ui_drag},
                             {"ui.open", path_alone<UiVerb::open>},
                             {"ui.close", path_alone<UiVerb::close>},
                             {"ui.menu", path_alone<UiVerb::menu>},
                             {"ui.scroll", parse_ui_scroll}};

}  // namespace

std::span<const LineRow> ui_lines() { return kUiLines; }

}  // namespace coaster::script
