// The actions of keys and menus, in one table: keys, menu, help and function.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "ui/tools/viewport_tool.h"

namespace coaster::ui {

struct CommandPalette;

// The context of an action.
struct ActionContext {
  Ui& ui;
  ViewportTool& tool;
  const view::Viewport& scene;
  const view::Viewport& free;  // its part that nothing covers
  const view::Pick& hovered;   // under the mouse in the previous frame
  CommandPalette& palette;
};

// When an action can run, and the sentence shown when it cannot.
struct ActionCondition {
  bool (*holds)(const ActionContext& act);
  std::string_view otherwise;
};
inline constexpr ActionCondition kAlways{[](const ActionContext&) { return true; }, ""};

struct Action {
  std::string_view name;     // shown in the menu
  std::string_view menu;     // "View", or "View/Camera" for a menu inside; "" if it is in none
  platform::KeyChord chord;  // default key; Key::unknown for none (the user's settings may replace it: KeyMap)
  // kRepeats: again while the key is held; kInDrag: while the mouse drags something, too; kOnStart: on the start
  // screen, too.
  unsigned keys;
  std::string_view help;
  void (*run)(ActionContext& act);
  ActionCondition enabled = kAlways;
  bool (*checked)(const ActionContext& act) = nullptr;  // null: no mark
  platform::KeyChord other = {};                        // a second default key
};
inline constexpr unsigned kRepeats = 1, kInDrag = 2, kOnStart = 4;

std::span<const Action> actions();
// Returns the names and default keys of the actions, in the order of actions().
std::vector<KeyRow> key_rows();

// Runs the actions of the pressed keys, of those with all flags of `only`. Do not call it while a text field has the
// keyboard.
void run_keys(ActionContext& act, const platform::Events& events, unsigned only = 0);
// Runs the keys of an active transform, and those of actions that may interrupt it (undo, Escape).
void run_transform_keys(ActionContext& act, const platform::Events& events);
void build_menu(ActionContext& act);

}  // namespace coaster::ui
