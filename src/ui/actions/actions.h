// What keys and menus do: one table with the key, the menu, the help text and the commands it emits.
#pragma once

#include <span>
#include <string_view>

#include "ui/tools/viewport_tool.h"

namespace coaster::ui {

struct CommandPalette;

// What an action works with.
struct Act {
  Ui& ui;
  ViewportTool& tool;
  const view::Viewport& scene;
  const view::Pick& hovered;  // in the frame before
  CommandPalette& palette;
};

struct Action {
  std::string_view name;  // in the menu
  std::string_view menu;  // "" when it is in none
  std::string_view keys;  // the first of them, as shown: "Ctrl+Z"
  platform::Chord chord,
      other;     // other: a second key, Key::unknown for none; the user's settings may name others (key_map.h)
  bool repeats;  // while the key is held
  bool in_drag;  // allowed while the mouse drags something
  std::string_view help;
  bool (*enabled)(const Act& act);
  bool (*checked)(const Act& act);  // null: no mark
  void (*run)(Act& act);
};
std::span<const Action> actions();

// Runs what the pressed keys ask for. Not to be called while a text field has the keyboard.
void run_keys(Act& act, const platform::Events& events);
// While a transform is under way: its own keys, and those of actions that may interrupt it (undo, Escape).
void run_transform_keys(Act& act, const platform::Events& events);
void build_menu(Act& act);

}  // namespace coaster::ui
