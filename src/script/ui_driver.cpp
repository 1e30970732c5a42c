// Operates widgets; ui_driver_find.cpp finds them. It never activates a widget by id: if a mouse cannot press it, that
// is an error.
#include "script/ui_driver.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace coaster::script {
namespace {

using platform::Button;
using platform::Key;
using platform::KeyPress;
using platform::MouseButton;
using platform::MouseMove;

// Returns the number that a widget shows, without its unit.
std::optional<double> number_shown(const std::string& text) {
  for (std::size_t size = text.size(); size > 0; --size)
    if (const auto number = base::parse_double(std::string_view(text).substr(0, size))) return number;
  return std::nullopt;
}

// Fails with the widget's kind if that is none of `kinds`.
Failure expect_kind(const WidgetState& widget, std::initializer_list<std::string_view> kinds,
                    std::string_view expected) {
  if (std::find(kinds.begin(), kinds.end(), widget.kind) != kinds.end()) return {};
  return wrong(fmt::format("{} is a {}, expected a {}", base::quoted_start(widget.path),
                           widget.kind == "item" ? "menu item" : widget.kind, expected));
}

}  // namespace

Failure UiDriver::reach(std::string_view path) {
  if (Failure found = find(path, widget_); !found) return found;
  if (Failure sight = bring_into_sight(path, widget_); !sight) return sight;
  if (Failure refused = refusal(widget_); !refused) return refused;
  if (Failure moved = frame({middle(widget_)}); !moved) return moved;
  if (const WidgetState* const hovered = now(path)) widget_ = *hovered;  // hovering may change the layout
  return refusal(widget_);
}

// A press or key that takes effect at once may leave its release to the next frame, so that the last frame's numbers
// show the effect.
Failure UiDriver::release(platform::Event event, std::uint64_t commands_before, bool can_wait) {
  if (can_wait && frames_.commands() != commands_before) {
    frames_.put_off({std::move(event)});
    return {};
  }
  if (Failure up = frame({std::move(event)}); !up) return up;
  // Some widgets report their result one frame after the release.
  return frames_.commands() == commands_before ? frame({}) : Failure{};
}

Failure UiDriver::press_and_release(platform::Modifiers modifiers) {
  const std::uint64_t before = frames_.commands();
  if (Failure down = frame({MouseButton{Button::left, true, modifiers}}); !down) return down;
  return release(MouseButton{Button::left, false, modifiers}, before, false);
}

Failure UiDriver::key(Key which, platform::Modifiers modifiers, bool release_can_wait) {
  const std::uint64_t before = frames_.commands();
  if (Failure down = frame({KeyPress{which, true, false, modifiers}}); !down) return down;
  return release(KeyPress{which, false, false, {}}, before, release_can_wait);
}

Failure UiDriver::click(std::string_view path, int clicks) {
  if (Failure reached = reach(path); !reached) return reached;
  for (int i = 0; i < clicks; ++i)
    if (Failure pressed = press_and_release({}); !pressed) return pressed;
  return {};
}

Failure UiDriver::check(std::string_view path, bool on) {
  if (Failure reached = reach(path); !reached) return reached;
  if (Failure other = expect_kind(widget_, {"checkbox", "radio", "item", "header"}, "checkbox or radio button"); !other)
    return other;
  if (is_on(widget_) == on) return {};
  if (!on && widget_.kind == "radio")
    return failed(base::quoted_start(widget_.path) + " is a radio button: it turns off when another one is selected");
  return press_and_release({});
}

Failure UiDriver::type(std::string_view path, std::string_view text) {
  if (Failure reached = reach(path); !reached) return reached;
  if (Failure other = expect_kind(widget_, {"text", "number", "slider", "cell"}, "field, slider or cell"); !other)
    return other;
  const platform::Modifiers ctrl{false, true, false};
  const bool plain = widget_.kind == "text" || widget_.kind == "cell";
  if (Failure opened = press_and_release(plain ? platform::Modifiers{} : ctrl); !opened) return opened;
  if (widget_.kind == "cell")  // a double click opens it, and its field takes the keyboard a frame later
    if (Failure opened = press_and_release({}); !opened || !(opened = frame({}))) return opened;
  if (Failure all = key(Key::a, ctrl); !all) return all;
  if (Failure typed = frame(
          text.empty() ? platform::Events{KeyPress{Key::del, true, false, {}}, KeyPress{Key::del, false, false, {}}}
                       : platform::Events{platform::TextInput{std::string(text)}});
      !typed)
    return typed;
  return key(Key::enter, {}, true);
}

Failure UiDriver::drag_by(std::string_view path, float pixels) {
  if (Failure reached = reach(path); !reached) return reached;
  const MouseMove from = middle(widget_);
  if (Failure down = frame({MouseButton{Button::left, true, {}}}); !down) return down;
  constexpr int kSteps = 4;
  for (int i = 1; i <= kSteps; ++i)
    if (Failure moved = frame({MouseMove{from.x + pixels * static_cast<float>(i) / kSteps, from.y}}); !moved)
      return moved;
  const std::uint64_t before = frames_.commands();
  return release(MouseButton{Button::left, false, {}}, before, false);
}

Failure UiDriver::drag_to(std::string_view path, double value) {
  if (Failure reached = reach(path); !reached) return reached;
  if (Failure other = expect_kind(widget_, {"number", "slider", "plot"}, "number, slider or plot"); !other)
    return other;
  if (Failure down = frame({MouseButton{Button::left, true, {}}}); !down) return down;
  const float y = middle(widget_).y;
  float low = widget_.x, high = widget_.x + widget_.width;
  bool there = false;
  for (int i = 0; i < 16 && high - low > 0.5f && !there; ++i) {
    const float x = (low + high) / 2;
    // Two frames: a slider shows its value at the start of a frame.
    if (Failure moved = frame({MouseMove{x, y}}); !moved) return moved;
    if (Failure again = frame({}); !again) return again;
    const WidgetState* const shown = now(path);
    const auto number = shown ? number_shown(shown->value) : std::nullopt;
    if (!number) break;
    there = *number == value;
    (*number < value ? low : high) = x;
  }
  if (Failure up = release(MouseButton{Button::left, false, {}}, frames_.commands(), false); !up) return up;
  // A plot accepts no text, so the nearest pixel is used.
  return there || widget_.kind == "plot" ? Failure{} : type(path, base::to_text(value));
}

Failure UiDriver::open(std::string_view path, bool open) {
  if (Failure reached = reach(path); !reached) return reached;
  if (Failure other = expect_kind(widget_, {"header", "combo", "menu"}, "header, combo or menu"); !other) return other;
  if (widget_.kind == "header" && is_closed_header(widget_) != open) return {};
  return press_and_release({});
}

// "Edit/Undo": the menu Edit opens as part of the path.
Failure UiDriver::menu(std::string_view path) {
  const std::string in_bar = path.starts_with("Menu/") ? std::string(path) : "Menu/" + std::string(path);
  if (Failure clicked = click(in_bar); !clicked) return clicked;
  return expect_kind(widget_, {"menu", "item"}, "menu item");
}

Failure UiDriver::scroll(std::string_view path, double notches) {
  if (const base::Status settled = frames_.settle_panels(); !settled) return failure(settled);
  widgets_ = frames_.host().widgets();
  const WidgetState* over = nullptr;
  for (const WidgetState& widget : widgets_)
    if (!over && widget.visible && !widget.covered && (panel_of(widget.path) == path || widget.path == path))
      over = &widget;
  if (!over) {
    const auto found = find_widget(widgets_, path);
    if (!found) return failure(found.status());
    over = &widgets_[*found];
    if (Failure refused = refusal(*over); !refused) return refused;
  }
  if (Failure moved = frame({middle(*over)}); !moved) return moved;
  const int whole = static_cast<int>(std::ceil(std::abs(notches)));
  for (int i = 0; i < whole; ++i) {
    const double part = std::min(1.0, std::abs(notches) - i);
    if (Failure turned = frame({platform::Wheel{0, static_cast<float>(notches > 0 ? -part : part)}}); !turned)
      return turned;
  }
  return {};
}

}  // namespace coaster::script
