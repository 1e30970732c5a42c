// Autosaves: unsaved changes of a program that ended unexpectedly. Each running program has one: a track file, and next
// to it an info file "ID.info.json", which stays locked while its program runs. The next start therefore finds only the
// autosaves of crashed programs.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "base/crash_guard.h"
#include "base/file_lock.h"
#include "base/files.h"
#include "world/document.h"

namespace coaster::exchange {

inline constexpr std::string_view kAutosaveFormat = "coaster-autosave";
inline constexpr int kAutosaveVersion = 1;

// The contents of the info file.
struct AutosaveInfo {
  std::filesystem::path track;  // the autosaved track, in the same folder
  std::string original;         // the original file, absolute; empty: none
  std::string name;             // of the track
  std::int64_t time = 0;        // of the autosave, s since 1970
  int pid = 0;                  // the program that wrote it
  std::string hash;             // of the document, 16 hexadecimal digits
};
base::Result<AutosaveInfo> parse_autosave_info(std::string_view text, std::string_view name);
std::string print_autosave_info(const AutosaveInfo& info);

// The autosave of this program.
class Autosave {
 public:
  // Takes its name in the folder, which is created if needed; nothing is written. Code::io with the reason.
  base::Status reserve(base::Files& files, const std::filesystem::path& folder);
  const std::filesystem::path& info() const { return info_; }  // the info file; empty: no name is taken
  // Writes the track under a new name, then the info file that names it, then removes the previous track: at any time
  // the info file names a complete track. On an error the previous state stays. Code::io with the reason. Creates the
  // folder if needed.
  base::Status write(base::Files& files, const std::filesystem::path& folder, const world::Document& document,
                     const std::string& original, std::int64_t time);
  // Deletes the autosave, because the track was saved or its changes were discarded.
  void remove();
  bool exists() const { return !track_.empty(); }

 private:
  base::Files files_;  // of the last write()
  std::filesystem::path info_, track_;
  base::FileLock lock_;
  int serial_ = 0;
};

// Returns the files with which a crash leaves an autosave of this name, the info file last; none if they cannot be
// created. Its track has another name than an earlier autosave's, which stays complete until the info file is replaced.
std::vector<base::CrashFile> crash_files(base::Files& files, const std::filesystem::path& info,
                                         const world::Document& document, const std::string& original,
                                         std::int64_t time);

// An autosave of another program. While this object lives, no other program finds it.
struct FoundAutosave {
  AutosaveInfo info;
  std::filesystem::path info_file;
  base::FileLock lock;
  std::int64_t file_time = 0;  // last change of the original, s since 1970; 0: no such file
};

// Returns the autosaves in a folder whose programs no longer run, newest first. Removes orphans: tracks that no info
// file names, and temporary files of killed writers. Leaves unreadable info files alone.
std::vector<FoundAutosave> find_autosaves(base::Files& files, const std::filesystem::path& folder);

// Removes the track and its info file.
void discard(base::Files& files, FoundAutosave& found);

}  // namespace coaster::exchange
