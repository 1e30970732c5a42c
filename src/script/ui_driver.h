// Works widgets as a hand does: moves there, presses, releases, a frame each; scrolls and opens what hides them.
#pragma once

#include <functional>
#include <string>

#include "script/runner.h"
#include "script/stage.h"
#include "script/widgets.h"

namespace coaster::script {

class UiDriver {
 public:
  explicit UiDriver(Stage& stage) : stage_(stage) {}

  // Moves the cursor onto the widget, which must be one, in sight, enabled and uncovered. Headers and menus on the way
  // are opened. Errors: Code::usage when no or several widgets have the path; Code::expectation when it cannot be
  // reached, with the reason.
  Failure reach(std::string_view path);
  Failure click(std::string_view path, int clicks = 1);
  // Clicks when the widget's state is another one.
  Failure check(std::string_view path, bool on);
  // Ctrl+click opens a slider's or number's field too; then select all, the text, Enter.
  Failure type(std::string_view path, std::string_view text);
  Failure drag_by(std::string_view path, float pixels);
  // Moves along the slider until it shows the value; when no pixel does, types it.
  Failure drag_to(std::string_view path, double value);
  Failure open(std::string_view path, bool open);
  Failure menu(std::string_view path);
  // Positive: down. The path may be a panel's or a widget's in it.
  Failure scroll(std::string_view path, double notches);

 private:
  Failure frame(platform::Events events) { return failure(stage_.frame(std::move(events))); }
  Failure press_and_release(platform::Modifiers modifiers);
  Failure key(platform::Key key, platform::Modifiers modifiers, bool release_can_wait = false);
  Failure release(platform::Event event, std::uint64_t commands_before, bool can_wait);
  // The widget after opening headers on its path, as last drawn.
  Failure find(std::string_view path, WidgetState& widget);
  Failure open_way_to(std::string_view path);
  Failure open_one(WidgetState widget);
  Failure click_widget(const WidgetState& widget);
  Failure bring_into_sight(std::string_view path, WidgetState& widget);
  // Refuses what is not in sight, covered or disabled.
  Failure refusal(const WidgetState& widget) const;
  const WidgetState* now(std::string_view path);

  Stage& stage_;
  WidgetState widget_;  // of the last reach()
  std::vector<WidgetState> widgets_;
};

}  // namespace coaster::script
