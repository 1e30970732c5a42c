// The UI on any surface: feeds Dear ImGui with events, builds panels, tools and screens from const state, returns their
// commands, and draws with its own renderer. Changes no state of the program.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "gfx/gl.h"
#include "platform/events.h"
#include "ui/context/output.h"
#include "ui/context/state.h"
#include "ui/widgets/widget_list.h"

namespace coaster::ui {

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

  // Keys in place of the table's; returns what could not be done, a line each.
  std::vector<std::string> set_keys(std::span<const exchange::KeyChoice> choices);
  // The start screen: over everything until something is chosen.
  void show_start();
  // Opens a file or a shared link in the next frame, as if it was dropped: asks first about unsaved changes.
  void open(std::string path);
  // Columns, headers and the laboratory's strip as at the first start.
  void reset_layout();

  const std::vector<Widget>& widgets() const;  // of the last build
  const view::View& view() const;              // of the last build
  std::string toast() const;                   // text of the newest notice still shown
  // Returns for how long the panels stay as they are without events, s, from the time `seconds` on: while a notice
  // shows until it fades, in a text field until the caret blinks, in a list of files until it is read again.
  double still_for(double seconds) const;
  // True while a text field or a popup has the keyboard.
  bool wants_keyboard() const;

 private:
  struct Parts;
  explicit Host(std::unique_ptr<Parts> parts);
  std::unique_ptr<Parts> parts_;
};

}  // namespace coaster::ui
