// The key map: the default keys of the table of actions, changed by the user's settings.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "exchange/own/settings_file.h"
#include "platform/events.h"

namespace coaster::ui {

// An action and its default keys, Key::unknown for none. `name` outlives the map.
struct KeyRow {
  std::string_view name;
  platform::KeyChord first, second;
};

class KeyMap {
 public:
  // Returns the default keys of `rows`, replaced by `choices`. Adds a line to `problems` for each unknown action, each
  // unknown key and each key assigned twice, which leave the row unchanged; also for each default key that moved to
  // another action.
  static KeyMap make(std::span<const KeyRow> rows, std::span<const exchange::KeyBinding> choices,
                     std::vector<std::string>& problems);

  // Returns the keys of an action: none, one or two.
  std::span<const platform::KeyChord> chords(std::string_view action) const;
  // Returns the text of the action's first key; "" if it has none.
  std::string shown(std::string_view action) const;

 private:
  std::vector<std::string_view> names_;
  std::vector<std::vector<platform::KeyChord>> rows_;
};

// Returns the keys as text: "F Ctrl+Z" for `between` " ".
std::string chords_text(std::span<const platform::KeyChord> chords, std::string_view between);

// Returns "HELP Key C.", "HELP Keys Ctrl+Y, Ctrl+Shift+Z.", or the help alone.
std::string with_keys(const KeyMap& keys, std::string_view help, std::string_view action);

}  // namespace coaster::ui
