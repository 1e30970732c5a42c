// Folders: where the program's own files belong, and what is in a folder.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "base/status.h"

namespace coaster::base {

// By the XDG base directory specification (freedesktop.org), "coaster" below each; a variable that is not an absolute
// path is ignored, as it asks. Without HOME both are empty.
struct UserFolders {
  std::filesystem::path config;  // $XDG_CONFIG_HOME, else ~/.config
  std::filesystem::path state;   // $XDG_STATE_HOME, else ~/.local/state
};
UserFolders user_folders();

// Where the program's own data are: `tracks`, `challenges` and `envelopes` are folders in it. The first that is there
// of $COASTER_DATA (an absolute path; it is believed as it is), ../share/coaster beside the program's folder, the
// source tree that it was built from, and /usr/share/coaster. Empty without any.
std::filesystem::path data_folder();

// Makes a folder and those above it with `mode` less the process's mask: by default for its owner alone. Code::io with
// the reason.
Status make_folders(const std::filesystem::path& folder, unsigned mode = 0700);

struct FolderEntry {
  std::string name;
  bool folder = false;
  std::uintmax_t bytes = 0;  // of files
  std::int64_t time = 0;     // of the last change, s since 1970
};

// What is in a folder: folders first, each by name without regard to case. Links are followed; what cannot be examined,
// and what is neither file nor folder, is left out; so are names that begin with a dot, unless `hidden`. Code::bad_file
// with the reason.
Result<std::vector<FolderEntry>> list_folder(const std::filesystem::path& folder, bool hidden = false);

// The time of a file's last change, s since 1970; 0 when there is none.
std::int64_t change_time(const std::filesystem::path& file);

// "2026-03-01 09:05", by the clock of this place.
std::string local_time(std::int64_t seconds);

// "812 B", "4.1 kB", "12 MB".
std::string size_text(std::uintmax_t bytes);

}  // namespace coaster::base
