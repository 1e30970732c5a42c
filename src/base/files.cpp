#include "base/files.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <csignal>
#include <cstring>
#include <utility>

#include <fmt/format.h>

#include "base/hash.h"

namespace coaster::base {
namespace {

// A file descriptor that closes itself, for every way out of a function.
class Descriptor {
 public:
  explicit Descriptor(int fd) : fd_(fd) {}
  ~Descriptor() {
    if (fd_ >= 0) ::close(fd_);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  int get() const { return fd_; }
  bool valid() const { return fd_ >= 0; }
  int close() { return ::close(std::exchange(fd_, -1)); }

 private:
  int fd_;
};

Status failure(Code code, const std::filesystem::path& path, std::string_view what, int error) {
  return {code, fmt::format("{}: {}: {}", path.string(), what, std::strerror(error))};
}

Code code_of_open(int error) {
  return error == ENOENT || error == ENOTDIR || error == ELOOP || error == ENAMETOOLONG ? Code::bad_file : Code::io;
}

// Replaces a symbolic link by what it points to, which need not exist: std::filesystem::canonical would refuse that.
Status follow_links(std::filesystem::path& path) {
  const std::filesystem::path asked = path;
  std::error_code error;
  for (int depth = 0; std::filesystem::is_symlink(path, error); ++depth) {
    if (depth == 40) return failure(Code::io, asked, "the symbolic link cannot be followed", ELOOP);
    const std::filesystem::path next = std::filesystem::read_symlink(path, error);
    if (error) return failure(Code::io, asked, "the symbolic link cannot be followed", error.value());
    path = path.parent_path() / next;  // an absolute `next` replaces the whole
  }
  return {};
}

// ".1f2e3d4c.", for this machine.
std::string host_mark() {
  Hasher host;
  host.add(host_name());
  return "." + hex16(host.digest()).substr(0, 8) + ".";
}

// ".loop.json.1f2e3d4c." of "loop.json": what its temporary files start with on this machine. A process number says
// nothing about another machine's processes, so each has its own names; long names are cut, for the whole must stay
// below 255 bytes.
std::string temporary_stem(const std::filesystem::path& target) {
  constexpr std::size_t kMostBytes = 200;
  return fmt::format(".{}{}", target.filename().string().substr(0, kMostBytes), host_mark());
}

// A new file beside `target` with the mode that the process gives new files; `name` is its path. -1 and errno on
// failure.
int open_temporary(const std::filesystem::path& target, std::string& name) {
  const std::string stem = fmt::format("{}{}.", temporary_stem(target), ::getpid());
  for (int i = 0; i < 1000; ++i) {
    name = (target.parent_path() / (stem + std::to_string(i))).string();
    const int fd = ::open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (fd >= 0 || errno != EEXIST) return fd;
  }
  return -1;
}

std::filesystem::path folder_of(const std::filesystem::path& target) {
  return target.has_parent_path() ? target.parent_path() : ".";
}

// The number that a text starts with, cut off from it.
std::optional<int> take_number(std::string_view& text) {
  int number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc{}) return std::nullopt;
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  return number;
}

// Whether a name is that of a temporary file whose process is gone: it ends in host_mark() and "PID.NUMBER".
bool is_leftover(std::string_view name) {
  const std::string mark = host_mark();
  const std::size_t at = name.rfind(mark);
  if (!name.starts_with('.') || at == std::string_view::npos) return false;
  name.remove_prefix(at + mark.size());
  const auto pid = take_number(name);
  if (!pid || !name.starts_with('.')) return false;
  name.remove_prefix(1);
  return take_number(name) && name.empty() && !process_runs(*pid);
}

int sweep(const std::filesystem::path& folder, const std::string& stem) {
  int removed = 0;
  std::error_code error;
  for (std::filesystem::directory_iterator at(folder, error), end; !error && at != end; at.increment(error)) {
    const std::string name = at->path().filename().string();
    if (name.starts_with(stem) && is_leftover(name)) removed += ::unlink(at->path().c_str()) == 0 ? 1 : 0;
  }
  return removed;
}

}  // namespace

void Files::inject(IoOperation operation, int nth) { countdown_[static_cast<std::size_t>(operation)] = nth; }

bool Files::fails(IoOperation operation) {
  int& count = countdown_[static_cast<std::size_t>(operation)];
  if (count == 0 || --count > 0) return false;
  errno = EIO;
  return true;
}

Result<std::string> Files::read(const std::filesystem::path& path, std::size_t limit) {
  // O_NONBLOCK: opening a FIFO must not wait for a writer.
  Descriptor file(fails(IoOperation::open) ? -1 : ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
  if (!file.valid()) {
    const int error = errno;
    return failure(code_of_open(error), path, "cannot be opened", error);
  }
  struct stat info {};
  if (::fstat(file.get(), &info) != 0) return failure(Code::io, path, "cannot be examined", errno);
  if (S_ISDIR(info.st_mode)) return Status{Code::bad_file, path.string() + ": is a directory, expected a file"};
  if (!S_ISREG(info.st_mode)) return Status{Code::bad_file, path.string() + ": is not a regular file"};
  const Status too_large{Code::bad_file, fmt::format("{}: is larger than the limit of {} bytes", path.string(), limit)};
  if (static_cast<std::uint64_t>(info.st_size) > limit) return too_large;

  std::string bytes;
  std::array<char, 65536> chunk;
  for (;;) {
    const ssize_t got = fails(IoOperation::read) ? -1 : ::read(file.get(), chunk.data(), chunk.size());
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) return failure(Code::io, path, "cannot be read", errno);
    if (got == 0) return bytes;
    bytes.append(chunk.data(), static_cast<std::size_t>(got));
    if (bytes.size() > limit) return too_large;
  }
}

Status Files::write_atomic(const std::filesystem::path& path, std::string_view bytes) {
  std::filesystem::path target = path;
  if (const Status followed = follow_links(target); !followed.ok()) return followed;
  struct stat old {};
  const bool exists = ::stat(target.c_str(), &old) == 0;
  if (exists && !S_ISREG(old.st_mode))
    return {Code::io, path.string() + ": is not a regular file, so it cannot be written"};

  if (exists && ::access(target.c_str(), W_OK) != 0) return failure(Code::io, path, "is read-only", errno);

  (void)remove_leftovers(target);
  const std::filesystem::path folder = folder_of(target);
  // Opened before anything changes, so that all that can fail behind the rename is the folder's own fsync.
  Descriptor directory(fails(IoOperation::open) ? -1 : ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (!directory.valid()) return failure(Code::io, path, "open of the folder", errno);
  std::string temporary;
  Descriptor file(fails(IoOperation::open) ? -1 : open_temporary(target, temporary));
  if (!file.valid()) return failure(Code::io, path, "open", errno);
  // From here on every error removes the temporary file and leaves the old one as it was.
  const auto give_up = [&](std::string_view what) {
    const Status status = failure(Code::io, path, what, errno);
    ::unlink(temporary.c_str());
    return status;
  };

  if (exists && ::fchmod(file.get(), old.st_mode & 07777) != 0) return give_up("chmod");
  for (std::size_t done = 0; done < bytes.size();) {
    const ssize_t wrote =
        fails(IoOperation::write) ? -1 : ::write(file.get(), bytes.data() + done, bytes.size() - done);
    if (wrote < 0 && errno == EINTR) continue;
    if (wrote < 0) return give_up("write");
    done += static_cast<std::size_t>(wrote);
  }
  if (fails(IoOperation::fsync) || ::fsync(file.get()) != 0) return give_up("fsync");
  if (fails(IoOperation::close) || file.close() != 0) return give_up("close");
  if (fails(IoOperation::rename) || ::rename(temporary.c_str(), target.c_str()) != 0) return give_up("rename");

  // The new file is in place; without this a power cut could still bring the old one back.
  if (fails(IoOperation::fsync) || ::fsync(directory.get()) != 0)
    return failure(Code::io, path, "fsync of the folder", errno);
  return {};
}

std::string host_name() {
  char name[256] = "";
  (void)::gethostname(name, sizeof name - 1);
  return name;
}

bool process_runs(int pid) { return pid > 0 && (::kill(pid, 0) == 0 || errno == EPERM); }

int remove_leftovers(const std::filesystem::path& target) { return sweep(folder_of(target), temporary_stem(target)); }
int remove_leftovers_in(const std::filesystem::path& folder) { return sweep(folder, {}); }

}  // namespace coaster::base
