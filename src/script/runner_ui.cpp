// Statements that operate widgets.
#include <filesystem>

#include "script/ui_driver.h"

namespace coaster::script {

Failure Runner::perform(const UiAction& ui) {
  UiDriver driver(frames_);
  const std::string& path = ui.path.text;
  std::error_code ignored;
  const bool below_out = ui.text == "$OUT" || ui.text.starts_with("$OUT/");  // text fields that name files
  const std::string words =
      below_out ? std::filesystem::absolute(options_.out.folder(), ignored).string() + ui.text.substr(4) : ui.text;
  const auto act = [&]() -> Failure {
    switch (ui.verb) {
      case UiAction::Verb::click: return driver.click(path);
      case UiAction::Verb::doubleclick: return driver.click(path, 2);
      case UiAction::Verb::hover: return driver.reach(path);
      case UiAction::Verb::check: return driver.check(path, ui.on);
      case UiAction::Verb::type: return driver.type(path, words);
      case UiAction::Verb::drag_by: return driver.drag_by(path, static_cast<float>(ui.number));
      case UiAction::Verb::drag_to: return driver.drag_to(path, *base::parse_double(ui.text));
      case UiAction::Verb::open: return driver.open(path, true);
      case UiAction::Verb::close: return driver.open(path, false);
      case UiAction::Verb::menu: return driver.menu(path);
      case UiAction::Verb::scroll: return driver.scroll(path, ui.number);
    }
    return {};
  };
  Failure result = act();
  if (!result && result.column == 0) result.column = ui.path.column;
  return result;
}

}  // namespace coaster::script
