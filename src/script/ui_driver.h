// Operates widgets like a user: moves there, presses, releases, one frame each; first scrolls and opens what hides
// them.
#pragma once

#include <string>

#include "script/frame_stepper.h"
#include "script/widget_lookup.h"

namespace coaster::script {

inline platform::MouseMove middle(const query::Widget& w) { return {w.x + w.width / 2, w.y + w.height / 2}; }

class UiDriver {
 public:
  explicit UiDriver(FrameDriver& frames) : frames_(frames) {}

  // Moves the cursor onto the widget, which must be unique, visible, enabled and uncovered. Opens headers and menus on
  // the path. Errors: Code::usage if no or several widgets match the path; Code::expectation with the reason if it
  // cannot be reached, such as the workspace that shows it.
  Status reach(std::string_view path);
  Status click(std::string_view path, int clicks = 1);
  // Clicks the widget if it is in the other state.
  Status check(std::string_view path, bool on);
  // Opens the field by Ctrl+click on a slider or number, or by a double click on a table's cell; then selects all,
  // types the text and presses Enter.
  Status type(std::string_view path, std::string_view text);
  Status drag_by(std::string_view path, float pixels);
  // Drags along the slider until it shows the value; types the value if no pixel does.
  Status drag_to(std::string_view path, double value);
  Status open(std::string_view path, bool open);
  Status menu(std::string_view path);
  // Scrolls; positive scrolls down. The path is that of a panel or of a widget in it.
  Status scroll(std::string_view path, double notches);

 private:
  // The same as reach(), for a widget of one of these kinds, which `expected` describes. Code::usage for another one.
  Status reach_a(std::initializer_list<std::string_view> kinds, std::string_view expected, std::string_view path);
  Status frame(platform::Events events) { return frames_.frame(std::move(events)); }
  Status press_and_release(platform::Modifiers modifiers);
  Status key(platform::Key key, platform::Modifiers modifiers, bool release_can_wait = false);
  Status release(platform::Event event, std::uint64_t commands_before, bool can_wait);
  // Finds the widget as last drawn, after opening headers on its path.
  Status find(std::string_view path, query::Widget& widget);
  Status refuse_missing(std::string_view path, const Status& missing);
  Status open_way_to(std::string_view path);
  Status open_inner_menu(std::string_view path);
  Status open_one(query::Widget widget);
  Status bring_into_sight(std::string_view path, query::Widget& widget);
  // Returns why a widget cannot be used: out of sight, covered or disabled.
  Status refusal(const query::Widget& widget) const;
  const query::Widget* now(std::string_view path);

  FrameDriver& frames_;
  query::Widget widget_;  // of the last reach()
  std::vector<query::Widget> widgets_;
  Status missing_;  // why an open menu lacks the widget: ok if none was open
};

}  // namespace coaster::script
