// Operates widgets. It never activates a widget by id: if a mouse cannot press it, that is an error.
#include "script/ui_driver.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/text.h"
#include "edit/commands/set_setting.h"
#include "query/condition.h"
#include "query/context.h"
#include "world/motion.h"
#include "world/panel_settings.h"

namespace coaster::script {
namespace {

using platform::Button;
using platform::Key;
using platform::KeyPress;
using platform::MouseButton;
using platform::MouseMove;

// --- Widgets by their paths

bool ends_in(std::string_view path, std::string_view tail) {
  return path.size() > tail.size() && path.ends_with(tail) && path[path.size() - tail.size() - 1] == '/';
}

std::vector<std::string> parts_of(std::string_view path) {
  std::vector<std::string> parts;
  while (true) {
    const std::size_t slash = path.find('/');
    parts.push_back(base::lower(path.substr(0, slash)));
    if (slash == std::string_view::npos) return parts;
    path.remove_prefix(slash + 1);
  }
}

// True if the wanted parts occur in `path` in order, the last one last.
bool has_parts(std::string_view path, const std::vector<std::string>& want) {
  const auto have = parts_of(path);
  if (have.back() != want.back()) return false;
  std::size_t next = 0;
  for (const std::string& part : have)
    if (next < want.size() && part == want[next]) ++next;
  return next == want.size();
}

template <class Fits>
std::vector<std::size_t> all(std::span<const query::Widget> widgets, Fits fits) {
  std::vector<std::size_t> found, labels;
  for (std::size_t i = 0; i < widgets.size(); ++i)
    if (fits(widgets[i].path) || (!widgets[i].alias.empty() && fits(widgets[i].alias)))
      (widgets[i].kind == "label" ? labels : found).push_back(i);
  return found.empty() ? labels : found;
}

std::string last_part(std::string_view path) { return std::string(path.substr(path.rfind('/') + 1)); }

std::string nearest_path(std::span<const query::Widget> widgets, std::string_view path) {
  std::vector<std::string> paths;
  for (const query::Widget& widget : widgets) paths.push_back(widget.path);
  if (std::string hint = base::suggestion(path, paths); !hint.empty()) return hint;
  std::vector<std::string> ends;
  for (const query::Widget& widget : widgets) ends.push_back(last_part(widget.path));
  const auto near = base::nearest(last_part(path), ends);
  if (!near) return {};
  const auto at = std::find(ends.begin(), ends.end(), *near) - ends.begin();
  return fmt::format("; did you mean {}?", base::quoted_start(paths[static_cast<std::size_t>(at)]));
}

constexpr int kMostScrolls = 80;

// True for a menu inside another, which opens under the cursor.
bool is_inner_menu(const query::Widget& w) {
  const bool titled = w.value == "open" || w.value == "closed";
  return w.kind == "menu" && titled && std::count(w.path.begin(), w.path.end(), '/') > 1;
}

}  // namespace

base::Status FrameDriver::apply(const edit::Command& command) {
  changed();  // a rejected command shows a notice
  return host_.apply(command);
}

base::Status FrameDriver::frame(platform::Events events, int ticks) {
  events.insert(events.begin(), put_off_.begin(), put_off_.end());
  put_off_.clear();
  const std::uint64_t before = commands();
  const base::Status status = host_.frame(events, ticks);
  picture_stale_ = false;
  panels_stale_ = !events.empty() || commands() != before;
  return status;
}

void FrameDriver::put_off(platform::Events events) {
  put_off_.insert(put_off_.end(), events.begin(), events.end());
  panels_stale_ = true;
}

void FrameDriver::advance(std::int64_t ticks) {
  if (ticks > 0) picture_stale_ = true;
  constexpr std::int64_t kSlice = world::kTicksPerSecond;
  while (ticks > 0 && !interrupted()) {
    const auto some = static_cast<int>(std::min(ticks, kSlice));
    host_.advance(some);
    ticks -= some;
  }
}

base::Status FrameDriver::settle() { return picture_stale_ ? frame({}, 0) : base::Status{}; }

base::Status FrameDriver::settle_panels() {
  if (!picture_stale_ && !panels_stale_) return {};
  for (int i = 0; i < 2; ++i)
    if (const base::Status status = frame({}, 0); !status) return status;
  return {};
}

std::vector<std::size_t> find_widgets(std::span<const query::Widget> widgets, std::string_view path) {
  if (path.size() > kMostPathBytes) return {};
  auto found = all(widgets, [&](std::string_view p) { return p == path; });
  if (found.empty()) found = all(widgets, [&](std::string_view p) { return ends_in(p, path); });
  const std::string low = base::lower(path);
  if (found.empty()) found = all(widgets, [&](std::string_view p) { return base::lower(p) == low; });
  if (found.empty()) found = all(widgets, [&](std::string_view p) { return ends_in(base::lower(p), low); });
  if (found.empty()) found = all(widgets, [want = parts_of(path)](std::string_view p) { return has_parts(p, want); });
  return found;
}

base::Result<std::size_t> find_widget(std::span<const query::Widget> widgets, std::string_view path) {
  if (path.size() > kMostPathBytes)
    return base::Status{base::Code::usage, fmt::format("expected a widget's path of at most {} bytes, found {}",
                                                       kMostPathBytes, path.size())};
  const std::vector<std::size_t> found = find_widgets(widgets, path);
  if (found.size() == 1) return found[0];
  if (found.empty())
    return base::Status{base::Code::usage,
                        fmt::format("no widget {}{}", base::quoted_start(path), nearest_path(widgets, path))};
  std::string list;
  for (const std::size_t i : found)
    list += fmt::format("{}{} ({})", list.empty() ? "" : ", ", base::quoted_start(widgets[i].path), widgets[i].kind);
  return base::Status{base::Code::usage, fmt::format("{} matches several widgets: {}", base::quoted_start(path), list)};
}

std::string_view panel_of(std::string_view path) { return path.substr(0, path.find('/')); }

bool is_on(const query::Widget& widget) { return widget.value == "on" || widget.value == "open"; }

bool is_closed_header(const query::Widget& widget) {
  return widget.kind == "header" && (widget.value == "off" || widget.value == "closed");
}

Status UiDriver::reach(std::string_view path) {
  if (Status found = find(path, widget_); !found) return found;
  if (Status sight = bring_into_sight(path, widget_); !sight) return sight;
  if (Status refused = refusal(widget_); !refused) return refused;
  if (Status moved = frame({middle(widget_)}); !moved) return moved;
  if (const query::Widget* const hovered = now(path)) widget_ = *hovered;  // hovering may change the layout
  return refusal(widget_);
}

Status UiDriver::reach_a(std::initializer_list<std::string_view> kinds, std::string_view expected,
                         std::string_view path) {
  if (Status reached = reach(path); !reached) return reached;
  if (std::find(kinds.begin(), kinds.end(), widget_.kind) != kinds.end()) return {};
  return wrong(fmt::format("{} is a {}, expected a {}", base::quoted_start(widget_.path),
                           widget_.kind == "item" ? "menu item" : widget_.kind, expected));
}

// A press or key that takes effect at once may leave its release to the next frame, so that the last frame's numbers
// show the effect.
Status UiDriver::release(platform::Event event, std::uint64_t commands_before, bool can_wait) {
  if (can_wait && frames_.commands() != commands_before) {
    frames_.put_off({std::move(event)});
    return {};
  }
  if (Status up = frame({std::move(event)}); !up) return up;
  // Some widgets report their result one frame after the release.
  return frames_.commands() == commands_before ? frame({}) : Status{};
}

Status UiDriver::press_and_release(platform::Modifiers modifiers) {
  const std::uint64_t before = frames_.commands();
  if (Status down = frame({MouseButton{Button::left, true, modifiers}}); !down) return down;
  return release(MouseButton{Button::left, false, modifiers}, before, false);
}

Status UiDriver::key(Key which, platform::Modifiers modifiers, bool release_can_wait) {
  const std::uint64_t before = frames_.commands();
  if (Status down = frame({KeyPress{which, true, false, modifiers}}); !down) return down;
  return release(KeyPress{which, false, false, {}}, before, release_can_wait);
}

Status UiDriver::click(std::string_view path, int clicks) {
  if (Status reached = reach(path); !reached) return reached;
  for (int i = 0; i < clicks; ++i)
    if (Status pressed = press_and_release({}); !pressed) return pressed;
  return {};
}

Status UiDriver::check(std::string_view path, bool on) {
  if (Status reached = reach_a({"checkbox", "radio", "item", "header"}, "checkbox or radio button", path); !reached)
    return reached;
  if (is_on(widget_) == on) return {};
  if (!on && widget_.kind == "radio")
    return failed(base::quoted_start(widget_.path) + " is a radio button: it turns off when another one is selected");
  return press_and_release({});
}

Status UiDriver::type(std::string_view path, std::string_view text) {
  if (Status reached = reach_a({"text", "number", "slider", "cell", "colour"}, "field, slider or cell", path); !reached)
    return reached;
  const platform::Modifiers ctrl{false, true, false};
  const bool plain = widget_.kind == "text" || widget_.kind == "cell" || widget_.kind == "colour";
  if (Status opened = press_and_release(plain ? platform::Modifiers{} : ctrl); !opened) return opened;
  if (widget_.kind == "cell")  // a double click opens it, and its field takes the keyboard a frame later
    if (Status opened = press_and_release({}); !opened || !(opened = frame({}))) return opened;
  if (Status all = key(Key::a, ctrl); !all) return all;
  if (Status typed = frame(
          text.empty() ? platform::Events{KeyPress{Key::del, true, false, {}}, KeyPress{Key::del, false, false, {}}}
                       : platform::Events{platform::TextInput{std::string(text)}});
      !typed)
    return typed;
  return key(Key::enter, {}, true);
}

Status UiDriver::drag_by(std::string_view path, float pixels) {
  if (Status reached = reach(path); !reached) return reached;
  const MouseMove from = middle(widget_);
  if (Status down = frame({MouseButton{Button::left, true, {}}}); !down) return down;
  constexpr int kSteps = 4;
  for (int i = 1; i <= kSteps; ++i)
    if (Status moved = frame({MouseMove{from.x + pixels * static_cast<float>(i) / kSteps, from.y}}); !moved)
      return moved;
  const std::uint64_t before = frames_.commands();
  return release(MouseButton{Button::left, false, {}}, before, false);
}

Status UiDriver::drag_to(std::string_view path, double value) {
  if (Status reached = reach_a({"number", "slider", "plot"}, "number, slider or plot", path); !reached) return reached;
  if (Status down = frame({MouseButton{Button::left, true, {}}}); !down) return down;
  const float y = middle(widget_).y;
  float low = widget_.x, high = widget_.x + widget_.width;
  bool there = false;
  for (int i = 0; i < 16 && high - low > 0.5f && !there; ++i) {
    const float x = (low + high) / 2;
    // Two frames: a slider shows its value at the start of a frame.
    if (Status moved = frame({MouseMove{x, y}}); !moved) return moved;
    if (Status again = frame({}); !again) return again;
    const query::Widget* const shown = now(path);
    const auto number = shown ? query::leading_number(shown->value) : std::nullopt;
    if (!number) break;
    there = *number == value;
    (*number < value ? low : high) = x;
  }
  if (Status up = release(MouseButton{Button::left, false, {}}, frames_.commands(), false); !up) return up;
  // A plot accepts no text, so the nearest pixel is used.
  return there || widget_.kind == "plot" ? Status{} : type(path, base::to_text(value));
}

Status UiDriver::open(std::string_view path, bool open) {
  if (Status reached = reach_a({"header", "combo", "menu"}, "header, combo or menu", path); !reached) return reached;
  if (widget_.kind == "header" && is_closed_header(widget_) != open) return {};
  return press_and_release({});
}

// "Edit/Undo": the menu Edit opens as part of the path.
Status UiDriver::menu(std::string_view path) {
  const std::string in_bar = path.starts_with("Menu/") ? std::string(path) : "Menu/" + std::string(path);
  if (Status reached = reach_a({"menu", "item"}, "menu item", in_bar); !reached) return reached;
  return press_and_release({});
}

Status UiDriver::scroll(std::string_view path, double notches) {
  if (const Status settled = frames_.settle_panels(); !settled) return settled;
  widgets_ = frames_.host().widgets();
  const query::Widget* over = nullptr;
  for (const query::Widget& widget : widgets_)
    if (!over && widget.visible && !widget.covered && (panel_of(widget.path) == path || widget.path == path))
      over = &widget;
  if (!over) {
    const auto found = find_widget(widgets_, path);
    if (!found) return found.status();
    over = &widgets_[*found];
    if (Status refused = refusal(*over); !refused) return refused;
  }
  if (Status moved = frame({middle(*over)}); !moved) return moved;
  const int whole = static_cast<int>(std::ceil(std::abs(notches)));
  for (int i = 0; i < whole; ++i) {
    const double part = std::min(1.0, std::abs(notches) - i);
    if (Status turned = frame({platform::Wheel{0, static_cast<float>(notches > 0 ? -part : part)}}); !turned)
      return turned;
  }
  return {};
}

const query::Widget* UiDriver::now(std::string_view path) {
  widgets_ = frames_.host().widgets();
  const std::vector<std::size_t> found = find_widgets(widgets_, path);
  return found.size() == 1 ? &widgets_[found[0]] : nullptr;
}

Status UiDriver::refusal(const query::Widget& widget) const {
  if (!widget.visible) return failed(base::quoted_start(widget.path) + " is out of sight");
  if (widget.covered) return failed(base::quoted_start(widget.path) + " is covered by another window");
  if (!widget.enabled) return failed(base::quoted_start(widget.path) + " is disabled");
  return {};
}

Status UiDriver::open_one(query::Widget widget) {
  const std::string path = widget.path;
  if (Status sight = bring_into_sight(path, widget); !sight) return sight;
  if (Status refused = refusal(widget); !refused) return refused;
  if (Status moved = frame({middle(widget)}); !moved) return moved;
  if (!is_inner_menu(widget))
    if (Status clicked = press_and_release({}); !clicked) return clicked;
  return frames_.settle_panels();
}

// Opens headers, combos and menus on the path; then the closed headers of its panel, and the menus inside its menu.
Status UiDriver::open_way_to(std::string_view path) {
  if (path.size() > kMostPathBytes) return {};
  const auto missing = [&] { return find_widgets(frames_.host().widgets(), path).empty(); };
  for (std::size_t slash = path.find('/'); slash != std::string_view::npos && missing();
       slash = path.find('/', slash + 1)) {
    const query::Widget* const parent = now(path.substr(0, slash));
    const bool opens =
        parent && (is_closed_header(*parent) || parent->kind == "combo" || (parent->kind == "menu" && !is_on(*parent)));
    if (!opens) continue;
    if (Status opened = open_one(*parent); !opened) return opened;
  }
  const std::string panel(panel_of(path));
  std::vector<std::string> tried;
  for (bool again = true; again && missing();) {
    again = false;
    widgets_ = frames_.host().widgets();
    for (const query::Widget& widget : widgets_) {
      if (!is_closed_header(widget) || panel_of(widget.path) != panel) continue;
      if (std::find(tried.begin(), tried.end(), widget.path) != tried.end()) continue;
      tried.push_back(widget.path);
      if (Status opened = open_one(widget); !opened) return opened;
      again = true;
      break;
    }
  }
  return missing() ? open_inner_menu(path) : Status{};
}

// Looks for the path's end in the menus inside its menu, one after the other.
Status UiDriver::open_inner_menu(std::string_view path) {
  const std::string menu(path.substr(0, path.rfind('/')));
  const query::Widget* const found = now(menu);
  if (!found || !is_on(*found) || found->path.find('/') == std::string::npos || found->kind != "menu") return {};
  const std::string outer = found->path;
  missing_ = find_widget(widgets_, path).status();
  std::vector<std::string> inner;
  for (const query::Widget& widget : widgets_)
    if (is_inner_menu(widget) && widget.enabled && widget.path.starts_with(outer + '/')) inner.push_back(widget.path);
  for (const std::string& one : inner) {
    if (const query::Widget* const title = now(outer); title && !is_on(*title))
      if (Status opened = open_one(*title); !opened) return opened;
    const query::Widget* const title = now(one);
    if (!title) return {};
    if (Status opened = open_one(*title); !opened) return opened;
    if (!find_widgets(frames_.host().widgets(), path).empty()) return {};
    // In a small window an open menu covers its neighbours. Escape closes the outer one, too.
    if (Status closed = key(Key::escape, {}); !closed) return closed;
    if (const Status settled = frames_.settle_panels(); !settled) return settled;
  }
  return {};
}

// Looks for a missing widget in each other workspace, and returns to the present one. Returns the refusal that names
// the first workspace that has it; `missing` if none has.
Status UiDriver::refuse_missing(std::string_view path, const Status& missing) {
  using world::Workspace;
  const Workspace here = frames_.host().context().session.settings.panels->workspace;
  const auto go_to = [&](Workspace workspace) {
    return frames_.apply(edit::Set<&world::Panels::workspace>{workspace}) && frames_.settle_panels();
  };
  std::string_view there;
  for (const Workspace workspace : {Workspace::build, Workspace::ride, Workspace::laboratory}) {
    if (workspace == here || !there.empty() || !go_to(workspace) || !open_way_to(path)) continue;
    if (!find_widgets(frames_.host().widgets(), path).empty()) there = base::name_of(workspace);
  }
  if (!go_to(here) || there.empty()) return missing;
  return failed(
      fmt::format("{} is in the workspace {}: write \"workspace {}\" before", base::quoted_start(path), there, there));
}

Status UiDriver::find(std::string_view path, query::Widget& widget) {
  if (const Status settled = frames_.settle_panels(); !settled) return settled;
  missing_ = {};
  if (Status opened = open_way_to(path); !opened) return opened;
  widgets_ = frames_.host().widgets();
  const auto found = find_widget(widgets_, path);
  if (!found && path.size() <= kMostPathBytes && find_widgets(widgets_, path).empty()) {
    const Status missing = missing_.ok() ? found.status() : missing_;  // the search changes missing_
    return refuse_missing(path, missing);
  }
  if (!found) return found.status();
  widget = widgets_[*found];
  return {};
}

// Ranks how likely two widgets scroll together: same group, same panel, or neither.
int kinship(std::string_view a, std::string_view b) {
  if (a.substr(0, a.rfind('/')) == b.substr(0, b.rfind('/'))) return 2;
  return panel_of(a) == panel_of(b) ? 1 : 0;
}

// True if the wheel over `other` may scroll `widget`: menus scroll by themselves, and so do lists.
bool may_scroll_together(const query::Widget& widget, const query::Widget& other) {
  if (kinship(widget.path, other.path) == 2) return true;
  return panel_of(widget.path) != "Menu" && panel_of(other.path) != "Menu" && other.kind != "menu" &&
         other.kind != "item";
}

// Turns the wheel over the widget's column: at a visible widget of it, preferably of the same group.
Status UiDriver::bring_into_sight(std::string_view path, query::Widget& widget) {
  std::vector<std::string> useless;  // widgets over which the wheel moved nothing
  for (int i = 0; i < kMostScrolls && !widget.visible; ++i) {
    const query::Widget* over = nullptr;
    const float x = middle(widget).x;
    for (const query::Widget& other : widgets_) {
      if (!other.visible || other.covered || !may_scroll_together(widget, other)) continue;
      if (x < other.x || x > other.x + other.width) continue;
      if (std::find(useless.begin(), useless.end(), other.path) != useless.end()) continue;
      if (!over || kinship(other.path, widget.path) > kinship(over->path, widget.path)) over = &other;
    }
    if (!over) break;
    const MouseMove at{x, middle(*over).y};
    const std::string turned_over = over->path;
    const float notch = widget.y > at.y ? -1.0f : 1.0f;
    if (Status turned = frame({at, platform::Wheel{0, notch}}); !turned) return turned;
    if (const Status settled = frames_.settle_panels(); !settled) return settled;
    const query::Widget* const moved = now(path);
    if (!moved) break;
    if (moved->y == widget.y) useless.push_back(turned_over);
    widget = *moved;
  }
  return {};
}

}  // namespace coaster::script
