// The settings file of a user, JSON (docs/files.md): what is theirs and not a track's. What it cannot use it says, and
// keeps where it can.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/status.h"
#include "world/settings.h"

namespace coaster::exchange {

inline constexpr std::string_view kSettingsFormat = "coaster-settings";
inline constexpr int kSettingsVersion = 1;
inline constexpr std::size_t kMaxRecent = 10;
inline constexpr double kMinAutosave = 5, kMaxAutosave = 3600;  // s

// In the screen coordinates of the window system.
struct WindowPlace {
  int x = 0, y = 0, width = 1280, height = 720;
  bool maximised = false;
  friend bool operator==(const WindowPlace&, const WindowPlace&) = default;
};

// Keys of an action in place of its own: none, one or two, such as "Ctrl+Z".
struct KeyChoice {
  std::string action;
  std::vector<std::string> keys;
  friend bool operator==(const KeyChoice&, const KeyChoice&) = default;
};

struct UserSettings {
  UserSettings();                     // of a user who never changed any
  world::Settings session;            // what rows keep (kept_as); the others have the values that a session starts with
  double autosave_seconds = 30;       // kMinAutosave..kMaxAutosave
  std::optional<WindowPlace> window;  // none: where the window system puts it
  std::vector<std::string> recent;    // files, the newest first, at most kMaxRecent
  bool start_screen = true;           // whether a window without a track opens with it
  std::vector<KeyChoice> keys;        // as written, names that no action has included
  std::string others;                 // members of later versions, the text of a JSON object; "" without any
  friend bool operator==(const UserSettings&, const UserSettings&) = default;
};

struct LoadedSettings {
  UserSettings settings;
  std::vector<std::string> warnings;  // one line each: members that could not be used, and what stands in their place
};

// Parses a whole file's text. A member that is wrong becomes its default, with a warning. Code::bad_file, with one line
// as for tracks, for what is no settings file at all: broken JSON, another format. A newer version is read as far as it
// is known.
base::Result<LoadedSettings> parse_settings(std::string_view text, std::string_view name);

// Ends with a newline; parse_settings() gives the same settings back.
std::string print_settings(const UserSettings& settings);

// Puts a file to the front of the list.
void remember(std::vector<std::string>& recent, std::string file);

}  // namespace coaster::exchange
