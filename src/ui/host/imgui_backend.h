// The backend of Dear ImGui. It feeds it a frame's events: ImGui gets one change of a button per frame, at the position
// where it happened; further changes wait for the next frames. Double clicks depend on the time and position of the
// presses, not on the frame rate. The time of an event is that of its poll. Fingers scroll panels.
// It draws ImGui's draw lists with the program's GL table, the same on every surface. No gamma correction.
#pragma once

#include <imgui.h>

#include <array>
#include <cfloat>
#include <cstdint>
#include <deque>
#include <map>
#include <string>

#include "base/status.h"
#include "gfx/gl_objects.h"
#include "platform/events.h"

namespace coaster::ui {

// Keeps the order of what a player does faster than frames: the rest of a frame's events waits for the next one where
// it needs to see what came before.
class EventQueue {
 public:
  // Returns the events for this frame, with all of its ticks. A key or text waits until a click before it has been
  // seen: `clicks_wait` says that a former frame's is not. It also waits while a text field is about to take the
  // keyboard (`field_opens`), for at most three frames. Outside a text field one key press is seen a frame, because it
  // may open a field or a tool for the next one; in a text field the same holds for Enter, Tab and Escape, and
  // everything waits after a key with Ctrl, because Dear ImGui reads Ctrl at the end of the frame. A held key that
  // repeats does not wait.
  platform::Events take(const platform::Events& events, bool text_has_keyboard, bool clicks_wait, bool field_opens);
  bool waits() const { return !waiting_.empty(); }

 private:
  int opening_ = 0;  // frames for which a text field has been about to take the keyboard
  platform::Events waiting_;
};

class ImGuiInput {
 public:
  // Sets the display's size, the time step (the sum of the ticks), mouse, keys and text of the current context. Call it
  // before NewFrame. Tab goes to ImGui only while `text_has_keyboard`; otherwise it is the program's. Keys choose in
  // lists and menus, and with `page_of_choices` in the window with the focus.
  void feed(const platform::Events& events, int width, int height, bool text_has_keyboard,
            bool page_of_choices = false);
  bool clicks_wait() const { return !waiting_.empty(); }  // for the next frames: one takes a single change of a button
  bool keys_wait() const;                                 // presses of a key that ImGui must see released first
  bool listing() const { return listing_; }               // a list or menu is open, which gets this frame's keys
  bool finger() const { return finger_; }                 // the mouse is a finger on a touch screen

 private:
  using Buttons = std::array<bool, 3>;
  using Keys = std::array<bool, 22>;  // one for each row of kKeys
  void take_key(const platform::KeyPress& event, bool text_has_keyboard);
  void show_keys();
  void take_text(const std::string& utf8, bool ctrl);
  void take_button(const platform::MouseButton& event);
  void show_mouse(ImVec2 wheel);
  float scrolled_by_finger() const;

  // A change of a button that ImGui has not received, and the last press of a button.
  struct Change {
    std::size_t button;
    bool down, twice;
    ImVec2 at;
    platform::Modifiers modifiers;
  };
  struct Press {
    double time = -1e9;  // s
    ImVec2 at;
    bool twice = false;  // second press of a double click
  };

  double time_ = 0;    // s, the sum of the ticks
  double polled_ = 0;  // s, the earliest time of this frame's events
  std::deque<Change> waiting_;
  std::array<Press, 3> presses_;
  ImVec2 mouse_{-FLT_MAX, -FLT_MAX};  // ImGui's value for "no mouse"
  Buttons down_{};
  bool finger_ = false, listing_ = false;
  Keys held_{}, shown_{};                                      // now, and to ImGui in the last frame
  std::array<int, std::tuple_size_v<Keys>> presses_of_key_{};  // not shown yet
  platform::Modifiers modifiers_;
  std::string late_text_;
};

class ImGuiRenderer {
 public:
  // `gl` must outlive the renderer, and its context must be current in every call. Code::graphics with the compiler's
  // log on failure.
  static base::Result<ImGuiRenderer> make(const gfx::Gl& gl);
  // Draws into the bound framebuffer of that size. Leaves blending, scissor and depth test off and no program, array or
  // texture bound.
  void draw(const ImDrawData& data, int width, int height);

 private:
  ImGuiRenderer(const gfx::Gl& gl, gfx::ShaderProgram program);
  void update_textures();
  void draw_list(const ImDrawList& list, ImVec2 origin, int width, int height);

  const gfx::Gl* gl_;
  gfx::ShaderProgram program_;
  gfx::GlObject array_, vertices_, indices_;
  std::map<std::uintptr_t, gfx::GlObject> textures_;  // by texture id, from kOwnTexture on
};

}  // namespace coaster::ui
