#include "base/file_lock.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <utility>

#include <fmt/format.h>

#include "base/text.h"

namespace coaster::base {
namespace {

// The contents of the open lock file, "4711\nHOST\n"; missing parts are empty.
struct LockOwner {
  std::string pid, host;
};
LockOwner read_owner(int fd) {
  char text[320];
  const ssize_t got = ::pread(fd, text, sizeof text, 0);
  const std::string all(text, got > 0 ? static_cast<std::size_t>(got) : 0);
  const std::size_t first = all.find('\n');
  if (first == std::string::npos) return {};
  const std::size_t second = all.find('\n', first + 1);
  return {all.substr(0, first), all.substr(first + 1, second == std::string::npos ? second : second - first - 1)};
}

std::string describe(const LockOwner& owner) {
  if (owner.pid.empty()) return "another process";
  return fmt::format("process {}{}", owner.pid,
                     owner.host.empty() || owner.host == host_name() ? "" : " on " + owner.host);
}

// True if the locked file still has that name: its last owner may have removed it meanwhile.
bool is_still(int fd, const FileLocation& place) {
  struct stat mine {
  }, named{};
  return ::fstat(fd, &mine) == 0 &&
         ::fstatat(place.folder.get(), place.name.c_str(), &named, AT_SYMLINK_NOFOLLOW) == 0 &&
         mine.st_dev == named.st_dev && mine.st_ino == named.st_ino;
}

// A file with a second name belongs to someone else, and a pipe or device is no lock file.
bool is_lock_file(const struct stat& info) { return S_ISREG(info.st_mode) && info.st_nlink <= 1; }

// Opens the lock file; on failure returns an invalid descriptor and sets `reason`.
Descriptor open_lock(const FileLocation& place, std::string& reason) {
  constexpr const char* kForeign = "something else has the lock's name";
  struct stat info {};
  const bool exists = ::fstatat(place.folder.get(), place.name.c_str(), &info, AT_SYMLINK_NOFOLLOW) == 0;
  if (exists && !is_lock_file(info)) return reason = kForeign, Descriptor();
  Descriptor file(
      ::openat(place.folder.get(), place.name.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK, 0666));
  if (!file.valid()) return reason = std::strerror(errno), Descriptor();
  if (::fstat(file.get(), &info) != 0 || !is_lock_file(info)) return reason = kForeign, Descriptor();
  if (info.st_size > 0 && !parse_int(read_owner(file.get()).pid)) return reason = kForeign, Descriptor();
  return file;
}

}  // namespace

std::filesystem::path canonical_path(const std::filesystem::path& path) {
  std::error_code error;
  std::filesystem::path whole = std::filesystem::absolute(path, error);
  if (error) whole = path;
  for (int depth = 0; depth < 40 && std::filesystem::is_symlink(whole, error);
       ++depth)  // including a link to a missing file
    whole = whole.parent_path() / std::filesystem::read_symlink(whole, error);
  std::filesystem::path found = std::filesystem::weakly_canonical(whole, error);
  return error ? whole : found;
}

FileLock& FileLock::operator=(FileLock&& other) noexcept {
  if (this == &other) return *this;
  release();
  fd_ = std::move(other.fd_);
  target_ = std::exchange(other.target_, {});
  place_ = std::move(other.place_);
  return *this;
}

bool FileLock::covers(const std::filesystem::path& path) const { return held() && canonical_path(path) == target_; }

void FileLock::release() {
  if (!held()) return;
  ::unlinkat(place_.folder.get(), place_.name.c_str(), 0);  // while it is locked, so that no other program takes it
  (void)fd_.close();
  target_.clear();
  place_ = {};
}

LockAttempt try_lock(const std::filesystem::path& path, const FileRoot& root) {
  LockAttempt attempt;
  FileLock lock;
  lock.target_ = canonical_path(path);
  Result<FileLocation> place = root.locate(lock.target_);
  if (!place) {
    attempt.reason = place.status().message;
    return attempt;
  }
  lock.place_ = {std::move(place->folder), "." + place->name + ".lock"};
  for (int tries = 0; tries < 100; ++tries) {
    Descriptor file = open_lock(lock.place_, attempt.reason);
    if (!file.valid()) return attempt;
    const int locked = ::flock(file.get(), LOCK_EX | LOCK_NB), error = errno;
    const LockOwner owner = read_owner(file.get());
    if (locked != 0 && error != EWOULDBLOCK) {
      attempt.reason = std::strerror(error);
    } else if (locked != 0 || (!owner.host.empty() && owner.host != host_name())) {
      attempt.outcome = LockAttempt::Outcome::held;
      attempt.holder = describe(owner);
    } else if (!is_still(file.get(), lock.place_)) {
      continue;
    } else {
      const std::string text = fmt::format("{}\n{}\n", ::getpid(), host_name());
      const bool told = ::ftruncate(file.get(), 0) == 0 &&
                        ::pwrite(file.get(), text.data(), text.size(), 0) == static_cast<ssize_t>(text.size());
      (void)told;  // the lock is held even without this text; other programs then get no number
      lock.fd_ = std::move(file);
      attempt.outcome = LockAttempt::Outcome::taken;
      attempt.lock = std::move(lock);
    }
    return attempt;
  }
  attempt.reason = "its lock comes and goes";
  return attempt;
}

Result<Descriptor> claim_folder(const FileRoot& root) {
  Result<FileLocation> place = root.locate(root.folder() / "*");  // opens the folder
  if (!place) return place.status();
  if (::flock(place->folder.get(), LOCK_EX | LOCK_NB) == 0) return std::move(place->folder);
  if (errno != EWOULDBLOCK) return Descriptor();
  return Status{Code::refused, fmt::format("{}: another run of coaster writes there", root.folder().string())};
}

}  // namespace coaster::base
