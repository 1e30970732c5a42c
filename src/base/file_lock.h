// Who edits a file: a lock beside it, so that two running programs do not overwrite each other's work. The lock of a
// process that has died is free: the system lets go of it.
#pragma once

#include <filesystem>
#include <string>

#include "base/root.h"

namespace coaster::base {

// Held while the object lives. The lock of "tracks/loop.json" is the file "tracks/.loop.json.lock", locked by flock(2),
// with the lines "PID" and "HOST" in it; it goes with the lock.
class FileLock {
 public:
  FileLock() = default;
  ~FileLock() { release(); }
  FileLock(FileLock&& other) noexcept { *this = std::move(other); }
  FileLock& operator=(FileLock&& other) noexcept;

  bool held() const { return fd_.valid(); }
  const std::filesystem::path& target() const { return target_; }  // canonical; empty when nothing is held
  bool covers(const std::filesystem::path& path) const;            // by whatever name: links are followed
  void release();

 private:
  friend struct LockAttempt try_lock(const std::filesystem::path& path, const Root& root);
  Descriptor fd_;
  std::filesystem::path target_;
  Place place_;  // of the lock's file
};

struct LockAttempt {
  enum class Outcome { taken, held, impossible } outcome = Outcome::impossible;
  FileLock lock;       // when taken
  std::string holder;  // when held: "process 4711", or "process 4711 on HOST"
  std::string reason;  // when impossible: that of the system ("Read-only file system")
};

// Asks once, without waiting. A lock that this process holds already counts as held by it. The lock of another machine
// that shares the folder is believed as long as its file is there, for whether a process of that machine lives cannot
// be asked from here. Impossible where `root` does not let the lock's file be made, and where something else has its
// name.
LockAttempt try_lock(const std::filesystem::path& path, const Root& root = {});

// The one name of a file: absolute, links followed, whether or not it exists.
std::filesystem::path canonical_path(const std::filesystem::path& path);

}  // namespace coaster::base
