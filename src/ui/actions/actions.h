// The actions of keys and menus, in one table: keys, menu, help and function.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "ui/tools/viewport_tool.h"

namespace coaster::ui {

struct CommandPalette;

// The context of an action.
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
// Their names and default keys, in the order of actions().
std::vector<KeyRow> key_rows();

// Runs the actions of the pressed keys. Do not call it while a text field has the keyboard.
void run_keys(Act& act, const platform::Events& events);
// The same during a transform: handles its keys, and those of actions that may interrupt it (undo, Escape).
void run_transform_keys(Act& act, const platform::Events& events);
void build_menu(Act& act);

}  // namespace coaster::ui
