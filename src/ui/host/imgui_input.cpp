// Feeds a frame's events to Dear ImGui.
#include "ui/host/imgui_input.h"

#include <imgui_internal.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <variant>

#include "ui/screens/dialogs.h"
#include "ui/widgets/imgui_compat.h"

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

// The keys that text fields use.
constexpr std::pair<Key, ImGuiKey> kKeys[] = {{Key::tab, ImGuiKey_Tab},
                                              {Key::left, ImGuiKey_LeftArrow},
                                              {Key::right, ImGuiKey_RightArrow},
                                              {Key::up, ImGuiKey_UpArrow},
                                              {Key::down, ImGuiKey_DownArrow},
                                              {Key::page_up, ImGuiKey_PageUp},
                                              {Key::page_down, ImGuiKey_PageDown},
                                              {Key::home, ImGuiKey_Home},
                                              {Key::end, ImGuiKey_End},
                                              {Key::insert, ImGuiKey_Insert},
                                              {Key::del, ImGuiKey_Delete},
                                              {Key::backspace, ImGuiKey_Backspace},
                                              {Key::space, ImGuiKey_Space},
                                              {Key::enter, ImGuiKey_Enter},
                                              {Key::escape, ImGuiKey_Escape},
                                              {Key::keypad_enter, kKeypadEnter},
                                              {Key::a, ImGuiKey_A},
                                              {Key::c, ImGuiKey_C},
                                              {Key::v, ImGuiKey_V},
                                              {Key::x, ImGuiKey_X},
                                              {Key::y, ImGuiKey_Y},
                                              {Key::z, ImGuiKey_Z}};

// Returns how many of the open popups are not lists and menus in front of everything: a dialog.
int popups_behind_lists() {
  const auto& popups = ImGui::GetCurrentContext()->OpenPopupStack;
  int count = popups.Size;
  const auto is_dialog = [](const ImGuiWindow* w) { return w != nullptr && (w->Flags & ImGuiWindowFlags_Modal) != 0; };
  while (count > 0 && !is_dialog(popups[count - 1].Window)) --count;
  return count;
}

}  // namespace

platform::Events EventQueue::take(const platform::Events& events, bool text_has_keyboard, bool clicks_wait,
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

bool ImGuiInput::keys_wait() const {
  return std::ranges::any_of(presses_of_key_, [](int presses) { return presses > 0; });
}

void ImGuiInput::take_key(const platform::KeyPress& event, bool text_has_keyboard) {
  const auto* const row = std::ranges::find(kKeys, event.key, &std::pair<Key, ImGuiKey>::first);
  if (row == std::end(kKeys)) return;
  const auto key = static_cast<std::size_t>(row - kKeys);
  // Repeats come from ImGui's own timer.
  held_[key] = event.down && (text_has_keyboard || event.key != Key::tab);
  if (held_[key] && !event.repeat) ++presses_of_key_[key];
}

// Passes the keys to ImGui. A press that comes before ImGui has seen the key released waits a frame.
void ImGuiInput::show_keys() {
  for (std::size_t i = 0; i < shown_.size(); ++i) {
    const bool presses = presses_of_key_[i] > 0 && !shown_[i];
    presses_of_key_[i] -= presses ? 1 : 0;
    shown_[i] = presses || (presses_of_key_[i] == 0 && held_[i]);
    set_key(kKeys[i].second, shown_[i]);
  }
}

// Text of a frame that also has Ctrl down waits for the next frame, because ImGui would drop it.
void ImGuiInput::take_text(const std::string& utf8, bool ctrl) {
  if (ctrl) {
    late_text_ += utf8;
    return;
  }
  modifiers_.ctrl = false;  // text never comes with Ctrl: a stale one would make ImGui drop it
  ImGui::GetIO().AddInputCharactersUTF8(utf8.c_str());
}

void ImGuiInput::take_button(const platform::MouseButton& event) {
  constexpr double kSeconds = 0.3;  // between the presses of a double click, at least: frames may be longer
  const float reach = 2 * ImGui::GetIO().MouseDragThreshold;
  const auto button = static_cast<std::size_t>(event.button);
  Press& last = presses_[button];
  const bool twice = event.down && !last.twice && polled_ - last.time <= kSeconds &&
                     std::hypot(mouse_.x - last.at.x, mouse_.y - last.at.y) <= reach;
  if (event.down) last = {time_, mouse_, twice};
  waiting_.push_back({button, event.down, twice, mouse_, event.modifiers});
}

// Passes the mouse to ImGui: its position when a button changed, else the present one.
void ImGuiInput::show_mouse(ImVec2 wheel) {
  ImGuiIO& io = ImGui::GetIO();
  Buttons changed{};
  ImVec2 at = mouse_;
  while (!waiting_.empty() && !changed[waiting_.front().button]) {
    const Change& change = waiting_.front();
    changed[change.button] = true;
    down_[change.button] = change.down;
    at = change.at;
    modifiers_ = change.modifiers;
    // ImGui compares times of frames: these settings make it take every press for a second one, or none.
    if (change.down) io.MouseDoubleClickTime = io.MouseDoubleClickMaxDist = change.twice ? FLT_MAX : 0.0f;
    waiting_.pop_front();
  }
  set_mouse(at, wheel);
  for (std::size_t i = 0; i < down_.size(); ++i) set_button(static_cast<int>(i), down_[i]);
}

// Returns the notches of the wheel that keep what fingers drag in a panel below them: two fingers anywhere, one where
// it holds no widget.
float ImGuiInput::scrolled_by_finger() const {
  const ImGuiContext& g = *ImGui::GetCurrentContext();
  const ImGuiIO& io = g.IO;
  const bool holds_widget = g.ActiveId != 0 && !(g.ActiveIdWindow != nullptr && g.ActiveId == g.ActiveIdWindow->MoveId);
  const bool one = down_[0] && io.MouseDown[0] && !holds_widget, two = down_[2] && io.MouseDown[2];
  if (!finger_ || !io.WantCaptureMouse || !(one || two)) return 0;
  constexpr float kLines = 5;  // ImGui's step for a notch
  return (mouse_.y - io.MousePos.y) / (kLines * ImGui::GetFontSize());
}

void ImGuiInput::feed(const platform::Events& events, int width, int height, bool text_has_keyboard,
                      bool page_of_choices) {
  static_assert(std::tuple_size_v<Keys> == std::size(kKeys));
  ImGuiIO& io = ImGui::GetIO();
  io.DisplaySize = {static_cast<float>(width), static_cast<float>(height)};
  float seconds = 0;
  bool ctrl = false;
  ImVec2 wheel;
  if (!late_text_.empty()) take_text(std::exchange(late_text_, {}), false);
  for (const platform::Event& event : events)
    if (const auto* const tick = std::get_if<platform::Tick>(&event)) seconds += static_cast<float>(tick->dt);
  // A press comes at any time since the last poll; a longer time than a second is an idle window's wait for it.
  polled_ = time_ + std::max(0.0, static_cast<double>(seconds) - 1);
  time_ += static_cast<double>(seconds);
  for (const platform::Event& event : events) {
    if (const auto* const move = std::get_if<platform::MouseMove>(&event))
      mouse_ = {move->x, move->y}, finger_ = move->finger;
    else if (const auto* const turn = std::get_if<platform::Wheel>(&event)) wheel.x += turn->dx, wheel.y += turn->dy;
    else if (const auto* const press = std::get_if<platform::MouseButton>(&event)) {
      modifiers_ = press->modifiers;
      ctrl = ctrl || press->modifiers.ctrl;
      take_button(*press);
    } else if (const auto* const key = std::get_if<platform::KeyPress>(&event)) {
      modifiers_ = key->modifiers;
      ctrl = ctrl || key->modifiers.ctrl;
      take_key(*key, text_has_keyboard);
    } else if (const auto* const text = std::get_if<platform::TextInput>(&event)) {
      take_text(text->utf8, ctrl);
    } else if (const auto* const focus = std::get_if<platform::Focus>(&event); focus != nullptr && !focus->focused) {
      modifiers_ = {};
      waiting_.clear();
      down_ = {};
      held_ = {}, presses_of_key_ = {};
    }
  }
  wheel.y += scrolled_by_finger();
  show_mouse(wheel);
  show_keys();
  set_modifiers(modifiers_.ctrl, modifiers_.shift, modifiers_.alt);
  const int behind = popups_behind_lists();
  listing_ = behind < ImGui::GetCurrentContext()->OpenPopupStack.Size;
  set_list_keys((listing_ || page_of_choices) && !text_has_keyboard);
  // All of them: a menu inside another one would open again under the mouse.
  if (listing_ && !text_has_keyboard && pressed(events, Key::escape)) ImGui::ClosePopupToLevel(behind, true);
  // For fingers widgets reach half of the way to the next one.
  ImGuiStyle& style = ImGui::GetStyle();
  style.TouchExtraPadding = finger_ ? ImVec2(0.5f * style.ItemSpacing.x, 0.5f * style.ItemSpacing.y) : ImVec2();
  io.DeltaTime = seconds > 0 ? seconds : 1e-4f;  // ImGui asserts a positive step
}

}  // namespace coaster::ui
