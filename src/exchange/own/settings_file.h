// The settings file of a user, JSON (docs/files.md): everything that belongs to the user, not to a track. Reading
// reports invalid members and keeps the rest.
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
inline constexpr std::size_t kMaxOtherBytes = 16384;            // of unknown members, as text
inline constexpr double kMinAutosave = 5, kMaxAutosave = 3600;  // s

// Position and size in the window system's screen coordinates.
struct WindowPlace {
  int x = 0, y = 0, width = 1280, height = 720;
  bool maximised = false;
  friend bool operator==(const WindowPlace&, const WindowPlace&) = default;
};

// Keys that replace those of an action: none, one or two, such as "Ctrl+Z".
struct KeyBinding {
  std::string action;
  std::vector<std::string> keys;
  friend bool operator==(const KeyBinding&, const KeyBinding&) = default;
};

struct UserSettings {
  UserSettings();                     // the defaults
  world::Settings session;            // the kept rows (kept_as); others have their initial values
  double autosave_seconds = 30;       // kMinAutosave..kMaxAutosave
  std::optional<WindowPlace> window;  // none: the window system decides
  std::vector<std::string> recent;    // files, newest first, at most kMaxRecent
  bool start_screen = true;           // whether it opens when no track is given
  std::vector<KeyBinding> keys;       // as written, including names of unknown actions
  std::string others;                 // unknown members, as the text of a JSON object; "" without any
  friend bool operator==(const UserSettings&, const UserSettings&) = default;
};

struct LoadedSettings {
  UserSettings settings;
  std::vector<std::string> warnings;  // one line each: invalid members and their replacements
};

// Parses a whole file's text. An invalid member becomes its default, with a warning. Code::bad_file, with one line as
// for tracks, if the text is not a settings file of this version: broken JSON, another format, a newer version.
base::Result<LoadedSettings> parse_settings(std::string_view text, std::string_view name);

// Returns the text; ends with a newline. parse_settings() gives the same settings back.
std::string print_settings(const UserSettings& settings);

// Moves a file to the front of the list.
void remember(std::vector<std::string>& recent, std::string file);

}  // namespace coaster::exchange
