// The UI on any surface: feeds Dear ImGui with events, builds panels, tools and screens from const state, returns their
// commands, and draws with its own renderer. Changes no state of the program.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "gfx/gl.h"
#include "platform/events.h"
#include "ui/context/state.h"
#include "ui/host/imgui_backend.h"
#include "ui/widgets/widgets.h"

namespace coaster::ui {

// The card of a command that takes long, over the last picture. Panels read the session, which the command is changing
// meanwhile, so the card has a Dear ImGui context of its own, with the fonts and the style of the panels.
class WaitCard {
 public:
  // `panels`: their context, between two frames. Both it and the renderer must outlive the card.
  WaitCard(ImGuiContext& panels, ImGuiRenderer& renderer, float scale);
  ~WaitCard();
  WaitCard(const WaitCard&) = delete;
  WaitCard& operator=(const WaitCard&) = delete;

  // Draws into the bound framebuffer, which holds a picture of that size. Returns true if the user cancels.
  bool show(const platform::Events& events, const JobState& job, int width, int height);

 private:
  ImGuiContext* panels_;
  ImGuiContext* context_;
  ImGuiRenderer* renderer_;
  float scale_;
  ImGuiInput input_;
  bool dimmed_ = false;  // the picture behind it
};

class Host {
 public:
  static base::Result<std::unique_ptr<Host>> make(const gfx::Gl& gl);
  ~Host();
  Host(const Host&) = delete;
  Host& operator=(const Host&) = delete;

  // Builds one frame: feeds the events, builds menu, panels, viewport tool and status bar. width, height >= 1.
  Output build(const platform::Events& events, const UiState& state, int width, int height);
  // Draws the layout of the last build() into the bound framebuffer of that size.
  void draw(int width, int height);

  // Returns the card of a command that takes long. Build no frame while it exists.
  std::unique_ptr<WaitCard> make_wait_card();

  // Replaces the default keys. Returns the problems, one a line.
  std::vector<std::string> set_keys(std::span<const exchange::KeyBinding> choices);
  // Shows the start screen over everything until the user selects something.
  void show_start();
  // Opens a file or a shared link in the next frame, as if it was dropped: first asks about unsaved changes.
  void open(std::string path);
  // Restores the initial columns, headers and laboratory strip.
  void reset_layout();

  const std::vector<Widget>& widgets() const;  // those of the last build
  const view::View& view() const;              // that of the last build
  std::string toast() const;                   // text of the newest notice that still shows
  // Returns how long the panels stay unchanged without events, s, from the time `seconds` on: until a notice fades, the
  // caret of a text field blinks, or a list of files is read again.
  double still_for(double seconds) const;
  // True while clicks or keys wait for the next frames (EventQueue).
  bool input_waits() const;
  // True while a text field or a popup has the keyboard.
  bool wants_keyboard() const;

 private:
  struct Parts;
  explicit Host(std::unique_ptr<Parts> parts);
  std::unique_ptr<Parts> parts_;
};

}  // namespace coaster::ui
