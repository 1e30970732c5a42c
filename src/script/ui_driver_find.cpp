// Finds widgets: opens what hides them and scrolls them into sight.
#include <algorithm>

#include <fmt/format.h>

#include "edit/commands/set_setting.h"
#include "query/context.h"
#include "script/ui_driver.h"
#include "world/panels.h"

namespace coaster::script {
namespace {

constexpr int kMostScrolls = 80;
using platform::Key;
using platform::MouseMove;

// True for a menu inside another, which opens under the cursor.
bool is_inner_menu(const WidgetState& w) {
  const bool titled = w.value == "open" || w.value == "closed";
  return w.kind == "menu" && titled && std::count(w.path.begin(), w.path.end(), '/') > 1;
}

}  // namespace

const WidgetState* UiDriver::now(std::string_view path) {
  widgets_ = frames_.host().widgets();
  const std::vector<std::size_t> found = find_widgets(widgets_, path);
  return found.size() == 1 ? &widgets_[found[0]] : nullptr;
}

Failure UiDriver::refusal(const WidgetState& widget) const {
  if (!widget.visible) return failed(base::quoted_start(widget.path) + " is out of sight");
  if (widget.covered) return failed(base::quoted_start(widget.path) + " is covered by another window");
  if (!widget.enabled) return failed(base::quoted_start(widget.path) + " is disabled");
  return {};
}

Failure UiDriver::open_one(WidgetState widget) {
  const std::string path = widget.path;
  if (Failure sight = bring_into_sight(path, widget); !sight) return sight;
  if (Failure refused = refusal(widget); !refused) return refused;
  if (Failure moved = frame({middle(widget)}); !moved) return moved;
  if (!is_inner_menu(widget))
    if (Failure clicked = press_and_release({}); !clicked) return clicked;
  return failure(frames_.settle_panels());
}

// Opens headers, combos and menus on the path; then the closed headers of its panel, and the menus inside its menu.
Failure UiDriver::open_way_to(std::string_view path) {
  if (path.size() > kMostPathBytes) return {};
  const auto missing = [&] { return find_widgets(frames_.host().widgets(), path).empty(); };
  for (std::size_t slash = path.find('/'); slash != std::string_view::npos && missing();
       slash = path.find('/', slash + 1)) {
    const WidgetState* const parent = now(path.substr(0, slash));
    const bool opens =
        parent && (is_closed_header(*parent) || parent->kind == "combo" || (parent->kind == "menu" && !is_on(*parent)));
    if (!opens) continue;
    if (Failure opened = open_one(*parent); !opened) return opened;
  }
  const std::string panel(panel_of(path));
  std::vector<std::string> tried;
  for (bool again = true; again && missing();) {
    again = false;
    widgets_ = frames_.host().widgets();
    for (const WidgetState& widget : widgets_) {
      if (!is_closed_header(widget) || panel_of(widget.path) != panel) continue;
      if (std::find(tried.begin(), tried.end(), widget.path) != tried.end()) continue;
      tried.push_back(widget.path);
      if (Failure opened = open_one(widget); !opened) return opened;
      again = true;
      break;
    }
  }
  return missing() ? open_inner_menu(path) : Failure{};
}

// Looks for the path's end in the menus inside its menu, one after the other.
Failure UiDriver::open_inner_menu(std::string_view path) {
  const std::string menu(path.substr(0, path.rfind('/')));
  const WidgetState* const found = now(menu);
  if (!found || !is_on(*found) || found->path.find('/') == std::string::npos || found->kind != "menu") return {};
  const std::string outer = found->path;
  missing_ = find_widget(widgets_, path).status();
  std::vector<std::string> inner;
  for (const WidgetState& widget : widgets_)
    if (is_inner_menu(widget) && widget.enabled && widget.path.starts_with(outer + '/')) inner.push_back(widget.path);
  for (const std::string& one : inner) {
    if (const WidgetState* const title = now(outer); title && !is_on(*title))
      if (Failure opened = open_one(*title); !opened) return opened;
    const WidgetState* const title = now(one);
    if (!title) return {};
    if (Failure opened = open_one(*title); !opened) return opened;
    if (!find_widgets(frames_.host().widgets(), path).empty()) return {};
    // In a small window an open menu covers its neighbours. Escape closes the outer one, too.
    if (Failure closed = key(Key::escape, {}); !closed) return closed;
    if (const base::Status settled = frames_.settle_panels(); !settled) return failure(settled);
  }
  return {};
}

// Looks for a missing widget in each other workspace, and returns to the present one. Returns the refusal that names
// the first workspace that has it; `missing` if none has.
Failure UiDriver::refuse_missing(std::string_view path, const base::Status& missing) {
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
  if (!go_to(here) || there.empty()) return failure(missing);
  return failed(
      fmt::format("{} is in the workspace {}: write \"workspace {}\" before", base::quoted_start(path), there, there));
}

Failure UiDriver::find(std::string_view path, WidgetState& widget) {
  if (const base::Status settled = frames_.settle_panels(); !settled) return failure(settled);
  missing_ = {};
  if (Failure opened = open_way_to(path); !opened) return opened;
  widgets_ = frames_.host().widgets();
  const auto found = find_widget(widgets_, path);
  if (!found && path.size() <= kMostPathBytes && find_widgets(widgets_, path).empty()) {
    const base::Status missing = missing_.ok() ? found.status() : missing_;  // the search changes missing_
    return refuse_missing(path, missing);
  }
  if (!found) return failure(found.status());
  widget = widgets_[*found];
  return {};
}

// Ranks how likely two widgets scroll together: same group, same panel, or neither.
int kinship(std::string_view a, std::string_view b) {
  if (a.substr(0, a.rfind('/')) == b.substr(0, b.rfind('/'))) return 2;
  return panel_of(a) == panel_of(b) ? 1 : 0;
}

// True if the wheel over `other` may scroll `widget`: menus scroll by themselves, and so do lists.
bool may_scroll_together(const WidgetState& widget, const WidgetState& other) {
  if (kinship(widget.path, other.path) == 2) return true;
  return panel_of(widget.path) != "Menu" && panel_of(other.path) != "Menu" && other.kind != "menu" &&
         other.kind != "item";
}

// Turns the wheel over the widget's column: at a visible widget of it, preferably of the same group.
Failure UiDriver::bring_into_sight(std::string_view path, WidgetState& widget) {
  std::vector<std::string> useless;  // widgets over which the wheel moved nothing
  for (int i = 0; i < kMostScrolls && !widget.visible; ++i) {
    const WidgetState* over = nullptr;
    const float x = middle(widget).x;
    for (const WidgetState& other : widgets_) {
      if (!other.visible || other.covered || !may_scroll_together(widget, other)) continue;
      if (x < other.x || x > other.x + other.width) continue;
      if (std::find(useless.begin(), useless.end(), other.path) != useless.end()) continue;
      if (!over || kinship(other.path, widget.path) > kinship(over->path, widget.path)) over = &other;
    }
    if (!over) break;
    const MouseMove at{x, middle(*over).y};
    const std::string turned_over = over->path;
    const float notch = widget.y > at.y ? -1.0f : 1.0f;
    if (Failure turned = frame({at, platform::Wheel{0, notch}}); !turned) return turned;
    if (const base::Status settled = frames_.settle_panels(); !settled) return failure(settled);
    const WidgetState* const moved = now(path);
    if (!moved) break;
    if (moved->y == widget.y) useless.push_back(turned_over);
    widget = *moved;
  }
  return {};
}

}  // namespace coaster::script
