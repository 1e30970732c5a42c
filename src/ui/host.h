// Dear ImGui on any surface: fed from the event list, drawn by our own renderer over the GL table. Builds the panels and the viewport
// tool from const state and returns the commands they want; changes nothing itself.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "edit/commands.h"
#include "gfx/gl.h"
#include "platform/events.h"
#include "query/query.h"
#include "view/camera_rig.h"
#include "view/overlay.h"

namespace coaster::ui {

// A widget as last drawn, for scripts: path "Panel/Label" or "Panel/Group/Label".
struct Widget {
  std::string path;
  std::string kind;             // button, radio, checkbox, slider, number, text, combo, header, menu, item, label
  float x = 0, y = 0, width = 0, height = 0;  // px
  bool visible = true;          // inside its clip rectangle
  bool enabled = true;
  bool covered = false;         // another window lies over its middle
  std::string value;            // shown value or "on"/"off"
};

// What panels read.
struct State {
  const edit::Session& session;
  const query::FrameStats& stats;
  double seconds;               // since start, for fading notices and the cursor's blink
  bool scripted;                // times and fps read "--"
  const view::CameraRig* rig = nullptr;  // what pictures are taken with; null: settled at the state
};

// What a frame of the UI decides.
struct Output {
  std::vector<edit::Command> commands;
  view::View view;              // how to take the picture
  view::Pick hovered;
  bool quit = false;
  bool wants_screenshot = false;
};

class Host {
 public:
  static base::Result<std::unique_ptr<Host>> make(const gfx::Gl& gl, float content_scale);
  ~Host();
  Host(const Host&) = delete;
  Host& operator=(const Host&) = delete;

  // One frame: feeds the events, builds menu, panels, viewport tool and status bar. width, height >= 1.
  Output build(const platform::Events& events, const State& state, int width, int height);
  // Draws what build() laid out into the bound framebuffer of that size.
  void draw(int width, int height);

  const std::vector<Widget>& widgets() const;       // of the last build
  const view::View& view() const;                   // of the last build
  std::string toast() const;                        // text of the newest notice still shown
  // Where a widget scrolled out of sight would need the wheel: +1 down, -1 up, 0 in sight; and opening closed headers on its path.
  // True while a text field or a popup has the keyboard.
  bool wants_keyboard() const;

 private:
  struct Parts;
  explicit Host(std::unique_ptr<Parts> parts);
  std::unique_ptr<Parts> parts_;
};

}  // namespace coaster::ui
