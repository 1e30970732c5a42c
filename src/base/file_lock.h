// A lock file next to a file, so that two running programs do not overwrite each other's work. The system releases the
// lock of a process that has ended.
#pragma once

#include <filesystem>
#include <string>

#include "base/files.h"

namespace coaster::base {

// Held while the object lives. The lock of "tracks/loop.json" is the file "tracks/.loop.json.lock", locked by flock(2),
// with the lines "PID" and "HOST" in it; it is removed with the lock.
class FileLock {
 public:
  FileLock() = default;
  ~FileLock() { release(); }
  FileLock(FileLock&& other) noexcept { *this = std::move(other); }
  FileLock& operator=(FileLock&& other) noexcept;

  bool held() const { return fd_.valid(); }
  const std::filesystem::path& target() const { return target_; }  // canonical; empty if no lock is held
  bool covers(const std::filesystem::path& path) const;            // by any path to it: links are followed
  void release();

 private:
  friend struct LockAttempt try_lock(const std::filesystem::path& path, const FileRoot& root);
  Descriptor fd_;
  std::filesystem::path target_;
  FileLocation place_;  // of the lock file
};

struct LockAttempt {
  enum class Outcome { taken, held, impossible } outcome = Outcome::impossible;
  FileLock lock;       // if taken
  std::string holder;  // if held: "process 4711", or "process 4711 on HOST"
  std::string reason;  // if impossible: the system's reason ("Read-only file system")
};

// Tries once, without waiting. A lock of this process counts as held by it. The lock of another machine that shares the
// folder counts as held as long as its file exists, because its processes cannot be checked from here. Impossible if
// `root` does not allow the lock file, or something else has its name.
LockAttempt try_lock(const std::filesystem::path& path, const FileRoot& root = {});

// Takes the folder of a limited root while the descriptor is open, by flock(2) on the folder itself: no file is left,
// and the system releases it however the process ends. Code::refused while another run holds it. An invalid descriptor
// where the system has no such lock.
Result<Descriptor> claim_folder(const FileRoot& root);

// Returns the canonical path of a file, absolute and with links followed, whether or not it exists.
std::filesystem::path canonical_path(const std::filesystem::path& path);

}  // namespace coaster::base
