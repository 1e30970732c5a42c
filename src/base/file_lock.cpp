#include "base/file_lock.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <utility>

#include <fmt/format.h>

#include "base/files.h"

namespace coaster::base {
namespace {

// "4711\nHOST\n" of the open lock file; empty parts where it says nothing.
struct Owner {
  std::string pid, host;
};
Owner read_owner(int fd) {
  char text[320];
  const ssize_t got = ::pread(fd, text, sizeof text, 0);
  const std::string all(text, got > 0 ? static_cast<std::size_t>(got) : 0);
  const std::size_t first = all.find('\n');
  if (first == std::string::npos) return {};
  const std::size_t second = all.find('\n', first + 1);
  return {all.substr(0, first), all.substr(first + 1, second == std::string::npos ? second : second - first - 1)};
}

std::string describe(const Owner& owner) {
  if (owner.pid.empty()) return "another process";
  return fmt::format("process {}{}", owner.pid,
                     owner.host.empty() || owner.host == host_name() ? "" : " on " + owner.host);
}

// Whether the file that was locked is still the one of that name: its last owner may have removed it in between.
bool is_still(int fd, const std::filesystem::path& file) {
  struct stat mine {
  }, named{};
  return ::fstat(fd, &mine) == 0 && ::stat(file.c_str(), &named) == 0 && mine.st_dev == named.st_dev &&
         mine.st_ino == named.st_ino;
}

}  // namespace

std::filesystem::path canonical_path(const std::filesystem::path& path) {
  std::error_code error;
  std::filesystem::path whole = std::filesystem::absolute(path, error);
  if (error) whole = path;
  for (int depth = 0; depth < 40 && std::filesystem::is_symlink(whole, error);
       ++depth)  // also one that leads to what is not there yet
    whole = whole.parent_path() / std::filesystem::read_symlink(whole, error);
  std::filesystem::path found = std::filesystem::weakly_canonical(whole, error);
  return error ? whole : found;
}

FileLock& FileLock::operator=(FileLock&& other) noexcept {
  if (this == &other) return *this;
  release();
  fd_ = std::exchange(other.fd_, -1);
  target_ = std::exchange(other.target_, {});
  file_ = std::exchange(other.file_, {});
  return *this;
}

bool FileLock::covers(const std::filesystem::path& path) const { return held() && canonical_path(path) == target_; }

void FileLock::release() {
  if (fd_ < 0) return;
  ::unlink(file_.c_str());  // while it is locked, so that nobody else has it
  ::close(std::exchange(fd_, -1));
  target_.clear();
  file_.clear();
}

LockAttempt try_lock(const std::filesystem::path& path) {
  LockAttempt attempt;
  FileLock lock;
  lock.target_ = canonical_path(path);
  lock.file_ = lock.target_.parent_path() / ("." + lock.target_.filename().string() + ".lock");
  for (int tries = 0; tries < 100; ++tries) {
    const int fd = ::open(lock.file_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0666);
    if (fd < 0) {
      attempt.reason = std::strerror(errno);
      return attempt;
    }
    const int locked = ::flock(fd, LOCK_EX | LOCK_NB), error = errno;
    const Owner owner = read_owner(fd);
    if (locked != 0 && error != EWOULDBLOCK) {
      attempt.reason = std::strerror(error);
    } else if (locked != 0 || (!owner.host.empty() && owner.host != host_name())) {
      attempt.outcome = LockAttempt::Outcome::held;
      attempt.holder = describe(owner);
    } else if (!is_still(fd, lock.file_)) {
      ::close(fd);
      continue;
    } else {
      const std::string text = fmt::format("{}\n{}\n", ::getpid(), host_name());
      const bool told =
          ::ftruncate(fd, 0) == 0 && ::pwrite(fd, text.data(), text.size(), 0) == static_cast<ssize_t>(text.size());
      (void)told;  // the lock holds without it; whoever asks gets no number then
      lock.fd_ = fd;
      attempt.outcome = LockAttempt::Outcome::taken;
      attempt.lock = std::move(lock);
      return attempt;
    }
    ::close(fd);
    return attempt;
  }
  attempt.reason = "its lock comes and goes";
  return attempt;
}

}  // namespace coaster::base
