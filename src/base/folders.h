// The program's and the user's folders, and the contents of a folder.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "base/status.h"

namespace coaster::base {

// The user's folders by the XDG base directory specification (freedesktop.org), each with "coaster" appended; a
// variable that is not an absolute path is ignored, as specified. Without HOME both are empty.
struct UserFolders {
  std::filesystem::path config;  // $XDG_CONFIG_HOME, else ~/.config
  std::filesystem::path state;   // $XDG_STATE_HOME, else ~/.local/state
};
UserFolders user_folders();

// Returns the folder of the program's data, with `tracks`, `challenges` and `envelopes` in it: the first existing one
// of $COASTER_DATA (an absolute path, not checked), ../share/coaster relative to the program's folder, the source tree
// of the build, and /usr/share/coaster. Empty without any.
std::filesystem::path data_folder();

// True if a file was installed with the program: it is below data_folder(), and that is not the source tree.
bool is_installed(const std::filesystem::path& file);

// Creates a folder and its parents with `mode` less the process's mask; by default for the owner alone. Code::io with
// the reason.
Status make_folders(const std::filesystem::path& folder, unsigned mode = 0700);

struct FolderEntry {
  std::string name;
  bool folder = false;
  std::uintmax_t bytes = 0;  // size of a file
  std::int64_t time = 0;     // of the last change, s since 1970
};

// Returns the contents of a folder: folders first, each sorted by name ignoring case. Follows links; leaves out entries
// that cannot be examined or are neither file nor folder, the lists of files that runs made (kMadeList), and names that
// begin with a dot unless `hidden`. Code::bad_file with the reason.
Result<std::vector<FolderEntry>> list_folder(const std::filesystem::path& folder, bool hidden = false);

// Returns the time of a file's last change, s since 1970; 0 if there is no such file.
std::int64_t change_time(const std::filesystem::path& file);

// Returns "2026-03-01 09:05", in local time.
std::string local_time(std::int64_t seconds);

// Returns "812 B", "4.1 kB", "12 MB".
std::string size_text(std::uintmax_t bytes);

}  // namespace coaster::base
