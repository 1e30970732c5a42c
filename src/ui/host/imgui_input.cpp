// Feeds a frame's events to Dear ImGui.
#include "ui/host/imgui_input.h"

#include <variant>

#include <imgui.h>

#include "ui/widgets/imgui_compat.h"

namespace coaster::ui {
namespace {

using platform::Key;

// ImGui's name for the keys that its text fields use.
ImGuiKey imgui_key(Key key) {
  switch (key) {
    case Key::tab: return ImGuiKey_Tab;
    case Key::left: return ImGuiKey_LeftArrow;
    case Key::right: return ImGuiKey_RightArrow;
    case Key::up: return ImGuiKey_UpArrow;
    case Key::down: return ImGuiKey_DownArrow;
    case Key::page_up: return ImGuiKey_PageUp;
    case Key::page_down: return ImGuiKey_PageDown;
    case Key::home: return ImGuiKey_Home;
    case Key::end: return ImGuiKey_End;
    case Key::insert: return ImGuiKey_Insert;
    case Key::del: return ImGuiKey_Delete;
    case Key::backspace: return ImGuiKey_Backspace;
    case Key::space: return ImGuiKey_Space;
    case Key::enter: return ImGuiKey_Enter;
    case Key::escape: return ImGuiKey_Escape;
    case Key::keypad_enter: return kKeypadEnter;
    case Key::a: return ImGuiKey_A;
    case Key::c: return ImGuiKey_C;
    case Key::v: return ImGuiKey_V;
    case Key::x: return ImGuiKey_X;
    case Key::y: return ImGuiKey_Y;
    case Key::z: return ImGuiKey_Z;
    default: return ImGuiKey_COUNT;  // not one that text fields know
  }
}

void set_modifiers(const platform::Modifiers& m) {
  ImGuiIO& io = ImGui::GetIO();
#if IMGUI_VERSION_NUM >= 18900
  io.AddKeyEvent(ImGuiMod_Ctrl, m.ctrl);
  io.AddKeyEvent(ImGuiMod_Shift, m.shift);
  io.AddKeyEvent(ImGuiMod_Alt, m.alt);
#else
  io.KeyCtrl = m.ctrl;
  io.KeyShift = m.shift;
  io.KeyAlt = m.alt;
#endif
}

void move_mouse(ImGuiIO& io, const platform::MouseMove& e) {
#if IMGUI_VERSION_NUM >= 18700
  io.AddMousePosEvent(e.x, e.y);
#else
  io.MousePos = {e.x, e.y};
#endif
}

void turn_wheel(ImGuiIO& io, const platform::Wheel& e) {
#if IMGUI_VERSION_NUM >= 18700
  io.AddMouseWheelEvent(e.dx, e.dy);
#else
  io.MouseWheelH += e.dx;
  io.MouseWheel += e.dy;
#endif
}

}  // namespace

void ImGuiInput::feed_key(const platform::KeyPress& event, bool text_has_keyboard) {
  ImGuiIO& io = ImGui::GetIO();
  const ImGuiKey key = imgui_key(event.key);
  if (key == ImGuiKey_COUNT) return;
  const bool down = event.down && (text_has_keyboard || event.key != Key::tab);
#if IMGUI_VERSION_NUM >= 18700
  io.AddKeyEvent(key, down);
#else
  // The map from ImGui's keys to "native" ones is the identity; a key pressed and released in one frame counts as
  // pressed. A repeat is left to ImGui's own timer.
  io.KeyMap[key] = key;
  if (down) io.KeysDown[key] = true;
  held_[static_cast<std::size_t>(key)] = down;
#endif
}

void ImGuiInput::feed(const platform::Events& events, int width, int height, bool text_has_keyboard) {
  ImGuiIO& io = ImGui::GetIO();
  io.DisplaySize = {static_cast<float>(width), static_cast<float>(height)};
  float seconds = 0;
  bool ctrl = false;
  if (!late_text_.empty()) {
    modifiers_.ctrl = false;
    io.AddInputCharactersUTF8(late_text_.c_str());
    late_text_.clear();
  }
#if IMGUI_VERSION_NUM < 18700
  for (std::size_t key = 0; key < held_.size(); ++key) io.KeysDown[key] = held_[key];
  std::array<bool, 3> pressed{};
#endif
  for (const platform::Event& event : events) {
    if (const auto* const tick = std::get_if<platform::Tick>(&event)) seconds += static_cast<float>(tick->dt);
    else if (const auto* const move = std::get_if<platform::MouseMove>(&event)) move_mouse(io, *move);
    else if (const auto* const wheel = std::get_if<platform::Wheel>(&event)) turn_wheel(io, *wheel);
    else if (const auto* const press = std::get_if<platform::MouseButton>(&event)) {
      const auto button = static_cast<std::size_t>(press->button);
      modifiers_ = press->modifiers;
      ctrl = ctrl || press->modifiers.ctrl;
      down_[button] = press->down;
#if IMGUI_VERSION_NUM >= 18700
      io.AddMouseButtonEvent(static_cast<int>(button), press->down);
#else
      pressed[button] = pressed[button] || press->down;
#endif
    } else if (const auto* const key = std::get_if<platform::KeyPress>(&event)) {
      modifiers_ = key->modifiers;
      ctrl = ctrl || key->modifiers.ctrl;
      feed_key(*key, text_has_keyboard);
    } else if (const auto* const text = std::get_if<platform::TextInput>(&event); text != nullptr && ctrl) {
      late_text_ += text->utf8;
    } else if (text != nullptr) {
      modifiers_.ctrl = false;  // text never comes with Ctrl: a stale one would make ImGui drop it
      io.AddInputCharactersUTF8(text->utf8.c_str());
    } else if (const auto* const focus = std::get_if<platform::Focus>(&event); focus != nullptr && !focus->focused) {
      modifiers_ = {};
      down_ = {};
      held_ = {};
    }
  }
#if IMGUI_VERSION_NUM < 18700
  for (std::size_t button = 0; button < down_.size(); ++button) io.MouseDown[button] = down_[button] || pressed[button];
#endif
  set_modifiers(modifiers_);
  io.DeltaTime = seconds > 0 ? seconds : 1e-4f;  // ImGui asserts a positive step
}

}  // namespace coaster::ui
