#include "ui/host/event_order.h"

#include <algorithm>
#include <utility>
#include <variant>

namespace coaster::ui {
namespace {

using platform::Key;

// True if what follows the key must see its effect.
bool acts(const platform::KeyPress& press, bool text_has_keyboard) {
  if (!press.down || press.repeat || press.key == Key::unknown) return false;
  if (!text_has_keyboard) return true;
  constexpr Key kLeave[] = {Key::enter, Key::keypad_enter, Key::tab, Key::escape};
  return std::ranges::find(kLeave, press.key) != std::end(kLeave);
}

}  // namespace

platform::Events EventOrder::take(const platform::Events& events, bool text_has_keyboard, bool clicks_wait,
                                  bool field_opens) {
  constexpr int kMostFrames = 3;
  opening_ = field_opens && !text_has_keyboard ? opening_ + 1 : 0;
  const bool opens = opening_ > 0 && opening_ <= kMostFrames;
  platform::Events taken;
  const platform::Events before = std::exchange(waiting_, {});
  bool clicked = clicks_wait || opens, pressed = false, chorded = false;
  const auto take_one = [&](const platform::Event& event) {
    const auto* const press = std::get_if<platform::KeyPress>(&event);
    const bool button = std::holds_alternative<platform::MouseButton>(event);
    const bool key = press != nullptr && press->down && press->key != Key::unknown;
    // The text of a key comes right after it.
    const bool text = std::holds_alternative<platform::TextInput>(event);
    if (!waiting_.empty() || chorded || (clicked && (key || text)) || (pressed && (key || button))) {
      waiting_.push_back(event);
      return;
    }
    clicked = clicked || button;
    pressed = pressed || (press != nullptr && acts(*press, text_has_keyboard));
    chorded = key && text_has_keyboard && press->modifiers.ctrl;
    taken.push_back(event);
  };
  for (const platform::Event& event : before) take_one(event);
  for (const platform::Event& event : events)
    std::holds_alternative<platform::Tick>(event) ? taken.push_back(event) : take_one(event);
  return taken;
}

}  // namespace coaster::ui
