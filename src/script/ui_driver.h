// Operates widgets like a user: moves there, presses, releases, one frame each; first scrolls and opens what hides
// them.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "script/host.h"

namespace coaster::script {

using base::Status;

// Errors of statements that run: an expectation that does not hold or a target that cannot be used, and wrong use.
inline Status failed(std::string message) { return {base::Code::expectation, std::move(message)}; }
inline Status wrong(std::string message) { return {base::Code::usage, std::move(message)}; }

// A frame of a script is 1/60 s.
inline constexpr int kTicksPerFrame = 2;

// Draws frames for scripts: knows whether the picture is older than the state, and then draws a frame without ticks.
class FrameDriver {
 public:
  explicit FrameDriver(Host& host) : host_(host) {}

  Host& host() const { return host_; }
  // Takes note that the state changed otherwise than by the functions below.
  void changed() { picture_stale_ = panels_stale_ = true; }
  base::Status apply(const edit::Command& command);
  // Draws one frame with these events and the postponed ones.
  base::Status frame(platform::Events events, int ticks = kTicksPerFrame);
  // Adds events to the next frame.
  void put_off(platform::Events events);
  bool has_put_off() const { return !put_off_.empty(); }
  // Ends early where a signal asks the program to end.
  void advance(std::int64_t ticks);
  bool interrupted() const { return host_.interrupted && host_.interrupted(); }

  // Draws a frame without ticks if anything changed since the last one, so that the last frame's values match the
  // state.
  base::Status settle();
  // Draws until the panels show the state, too: in a frame with commands they show the state before them, and new
  // contents are laid out one frame later.
  base::Status settle_panels();

  std::uint64_t commands() const { return host_.commands ? host_.commands() : 0; }

 private:
  Host& host_;
  platform::Events put_off_;
  bool picture_stale_ = true;
  bool panels_stale_ = true;
};

// --- Widgets by their paths

inline constexpr std::size_t kMostPathBytes = 1000;  // of a widget's path; longer ones match nothing

// Returns the widgets that match a path, by the first of these rules that finds any: the whole path; its end after a
// slash ("Insert point" for "Track/Insert point"); both ignoring case; its parts in order with others in between
// ("Inspector/x" for "Inspector/Position/x"). Widgets that can be operated take precedence over plain labels.
// A widget's alias counts as its path.
std::vector<std::size_t> find_widgets(std::span<const query::Widget> widgets, std::string_view path);

// Returns the one widget of that path. Code::usage if there is none (with a suggestion) or several (with a list).
base::Result<std::size_t> find_widget(std::span<const query::Widget> widgets, std::string_view path);

// Returns the path's part before the first slash.
std::string_view panel_of(std::string_view path);

// True for a header whose contents are hidden.
bool is_closed_header(const query::Widget& widget);
bool is_on(const query::Widget& widget);

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
