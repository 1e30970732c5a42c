// Autosaves: what was not saved when a program ended without being asked. Each running program has one: a track file,
// and beside it a small file that says whose it is, "ID.info.json", which is locked while its program runs. So a start
// finds what crashed ones left, and no live one's.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/file_lock.h"
#include "base/files.h"
#include "world/document.h"

namespace coaster::exchange {

inline constexpr std::string_view kAutosaveFormat = "coaster-autosave";
inline constexpr int kAutosaveVersion = 1;

// What the small file says.
struct AutosaveInfo {
  std::filesystem::path track;  // the autosaved track, in the same folder
  std::string original;         // the file whose unsaved state it is, absolute; empty: it never had one
  std::string name;             // of the track
  std::int64_t time = 0;        // of the autosave, s since 1970
  int pid = 0;                  // of the program that wrote it
  std::string hash;             // of the document, 16 hexadecimal digits
};
base::Result<AutosaveInfo> parse_autosave_info(std::string_view text, std::string_view name);
std::string print_autosave_info(const AutosaveInfo& info);

// The autosave of this program.
class Autosave {
 public:
  // Writes the track under a new name, then the small file that names it, then removes the track before: at any time
  // what the small file names is whole. On an error what was there before stays. Code::io with the reason. Makes the
  // folder when there is none.
  base::Status write(base::Files& files, const std::filesystem::path& folder, const world::Document& document,
                     const std::string& original, std::int64_t time);
  // Forgets what was written: it is saved, or not wanted.
  void remove();
  bool exists() const { return !track_.empty(); }

 private:
  base::Files files_;  // of the last write()
  std::filesystem::path info_, track_;
  base::FileLock lock_;
  int serial_ = 0;
};

// One that another program left. While this lives, no other program finds it.
struct FoundAutosave {
  AutosaveInfo info;
  std::filesystem::path info_file;
  base::FileLock lock;
  std::int64_t file_time = 0;  // of the original's last change, s since 1970; 0: there is no such file
};

// All that programs that no longer run have left in a folder, the newest first. Removes what belongs to none: tracks
// that no small file names, temporary files of killed writers. A small file that cannot be read is left alone.
std::vector<FoundAutosave> find_autosaves(base::Files& files, const std::filesystem::path& folder);

// Removes the track and its small file.
void discard(base::Files& files, FoundAutosave& found);

}  // namespace coaster::exchange
