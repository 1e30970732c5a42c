#include "base/files.h"

#include <dirent.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstring>

#include <fmt/format.h>

#include "base/check.h"
#include "base/folders.h"
#include "base/hash.h"
#include "base/text.h"

namespace coaster::base {
namespace {

constexpr int kOpenFolder = O_RDONLY | O_DIRECTORY | O_CLOEXEC;

Status failure(const std::filesystem::path& path, std::string_view what, int error, Code code = Code::io) {
  return {code, fmt::format("{}: {}: {}", path.string(), what, std::strerror(error))};
}

// Returns an absolute path without ".", ".." and a slash at the end. Uses only the text.
std::filesystem::path plain(const std::filesystem::path& path) {
  std::error_code ignored;
  const std::filesystem::path whole = std::filesystem::absolute(path, ignored).lexically_normal();
  return whole.has_filename() ? whole : whole.parent_path();
}

// Replaces a symbolic link by its target, which need not exist: std::filesystem::canonical would fail then.
Status follow_links(std::filesystem::path& path) {
  const std::filesystem::path asked = path;
  std::error_code error;
  for (int depth = 0; std::filesystem::is_symlink(path, error); ++depth) {
    if (depth == 40) return failure(asked, "the symbolic link cannot be followed", ELOOP);
    const std::filesystem::path next = std::filesystem::read_symlink(path, error);
    if (error) return failure(asked, "the symbolic link cannot be followed", error.value());
    path = path.parent_path() / next;  // an absolute `next` replaces the whole path
  }
  return {};
}

bool is_link(int folder, const char* name) {
  struct stat info {};
  return ::fstatat(folder, name, &info, AT_SYMLINK_NOFOLLOW) == 0 && S_ISLNK(info.st_mode);
}

Result<FileLocation> locate_anywhere(std::filesystem::path target) {
  const std::filesystem::path asked = target;
  if (const Status followed = follow_links(target); !followed) return followed;
  const std::filesystem::path folder = target.has_parent_path() ? target.parent_path() : ".";
  Descriptor opened(::open(folder.c_str(), kOpenFolder));
  if (!opened.valid()) return failure(asked, "open of the folder", errno);
  return FileLocation{std::move(opened), target.has_filename() ? target.filename().string() : "."};
}

// Opens the list of the files that runs made in a folder; invalid if something else has its name.
Descriptor open_list(int folder, int flags) {
  Descriptor list(::openat(folder, kMadeList.data(), flags | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC, 0666));
  struct stat info {};
  const bool own = ::fstat(list.get(), &info) == 0 && S_ISREG(info.st_mode) && info.st_nlink == 1;
  return own ? std::move(list) : Descriptor();
}

// Returns whether an open folder has a file; links are not followed.
bool is_there(int folder, const std::string& name) {
  struct stat info {};
  return ::fstatat(folder, name.c_str(), &info, AT_SYMLINK_NOFOLLOW) == 0;
}

// Returns the list's text, a line for each file, and whether it has a file.
std::string made_in(int folder) {
  const Descriptor list = open_list(folder, O_RDONLY);
  std::string text = "\n";
  std::array<char, 65536> chunk;
  for (ssize_t got = 0; (got = ::read(list.get(), chunk.data(), chunk.size())) > 0;)
    text.append(chunk.data(), static_cast<std::size_t>(got));
  return text;
}
bool is_made(const std::string& list, std::string_view name) {
  return name.find('\n') == std::string_view::npos && list.find(fmt::format("\n{}\n", name)) != std::string::npos;
}

// Adds a file to the list. Where that fails the file is not replaced later.
void note_made(int folder, const std::string& name) {
  if (name.find('\n') != std::string::npos || is_made(made_in(folder), name)) return;
  const std::string line = name + '\n';
  const Descriptor list = open_list(folder, O_WRONLY | O_CREAT | O_APPEND);
  (void)!::write(list.get(), line.data(), line.size());
}

Status not_made(const std::filesystem::path& path) {
  return {Code::refused,
          fmt::format("{}: no run of coaster made this file, so it stays. Choose another name or folder, "
                      "or remove it yourself",
                      path.string())};
}

Code code_of_open(int error) {
  return error == ENOENT || error == ENOTDIR || error == ELOOP || error == ENAMETOOLONG ? Code::bad_file : Code::io;
}

// Returns ".1f2e3d4c.", a mark of this machine.
std::string host_mark() {
  Hasher host;
  host.add(host_name());
  return fmt::format(".{:.8}.", hex16(host.digest()));
}

// Returns ".loop.json.1f2e3d4c." for "loop.json": the start of its temporary files' names on this machine. Process
// numbers are unique only on one machine, so each machine has its own names. Long names are truncated to keep the total
// below 255 bytes.
std::string temporary_stem(const std::string& name) {
  constexpr std::size_t kMostBytes = 200;
  return fmt::format(".{}{}", name.substr(0, kMostBytes), host_mark());
}

// Creates a new file in the folder of `place` with the process's default mode; sets `name`. On failure returns an
// invalid descriptor, with errno.
Descriptor open_temporary(const FileLocation& place, std::string& name) {
  const std::string stem = fmt::format("{}{}.", temporary_stem(place.name), ::getpid());
  for (int i = 0; i < 1000; ++i) {
    name = fmt::format("{}{}", stem, i);
    const int fd =
        ::openat(place.folder.get(), name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0666);
    if (fd >= 0 || errno != EEXIST) return Descriptor(fd);
  }
  return Descriptor();
}

// True if a name is that of a temporary file whose process has ended: host_mark() and "PID.NUMBER" at the end.
bool is_leftover(std::string_view name) {
  const std::string mark = host_mark();
  const std::size_t at = name.rfind(mark);
  if (!name.starts_with('.') || at == std::string_view::npos) return false;
  name.remove_prefix(at + mark.size());
  const std::size_t dot = name.find('.');
  const auto pid = parse_int(name.substr(0, dot));
  return pid && dot != std::string_view::npos && parse_int(name.substr(dot + 1)) && !process_runs(*pid);
}

// Returns the names in an open folder.
std::vector<std::string> names_in(int folder) {
  std::vector<std::string> names;
  const int fd = ::openat(folder, ".", O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  DIR* const entries = fd < 0 ? nullptr : ::fdopendir(fd);
  if (entries == nullptr) {
    (void)Descriptor(fd);
    return names;
  }
  while (const dirent* const entry = ::readdir(entries))
    if (const std::string_view name = entry->d_name; name != "." && name != "..") names.emplace_back(name);
  ::closedir(entries);
  return names;
}

int sweep(int folder, const std::string& stem) {
  int removed = 0;
  for (const std::string& name : names_in(folder))
    if (name.starts_with(stem) && is_leftover(name)) removed += ::unlinkat(folder, name.c_str(), 0) == 0 ? 1 : 0;
  return removed;
}

// True for what runs leave beside the files that they made: the list, temporary files, and locks of files.
bool is_trace(const std::string& list, const std::string& name) {
  constexpr std::string_view kLock = ".lock";
  return name == kMadeList || is_leftover(name) ||
         (name.starts_with('.') && name.ends_with(kLock) &&
          is_made(list, std::string_view(name).substr(1, name.size() - 1 - kLock.size())));
}

using Visit = std::function<bool(int folder, const std::string& list, const std::string& name)>;
// Calls the visit for each file of an open folder, and with `deep` of those in it, until one returns false; the list
// comes last. Returns whether all were visited. Opens each folder relative to the previous one, never through a link.
bool visit_files(int folder, bool deep, const Visit& visit) {
  const std::string list = made_in(folder);
  std::vector<std::string> names = names_in(folder);
  std::stable_partition(names.begin(), names.end(), [](const std::string& name) { return name != kMadeList; });
  return std::all_of(names.begin(), names.end(), [&](const std::string& name) {
    const Descriptor inner(::openat(folder, name.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC));
    return !inner.valid() ? visit(folder, list, name) : !deep || visit_files(inner.get(), deep, visit);
  });
}

// Returns the place of a path without following its last name.
Result<FileLocation> place_itself(const FileRoot& root, const std::filesystem::path& path) {
  if (root.limited()) return root.locate(path);
  Result<FileLocation> place = root.locate(path.parent_path() / ".");
  if (place) place->name = path.filename().string();
  return place;
}

}  // namespace

Descriptor::Descriptor(Descriptor&& other) noexcept : fd_(std::exchange(other.fd_, -1)) {}

Descriptor& Descriptor::operator=(Descriptor&& other) noexcept {
  if (this != &other) (void)close(), fd_ = std::exchange(other.fd_, -1);
  return *this;
}

int Descriptor::close() { return fd_ < 0 ? 0 : ::close(std::exchange(fd_, -1)); }

struct FileRoot::LimitedFolder {
  Descriptor opened;
  std::filesystem::path given;
  std::array<std::filesystem::path, 2> names;  // absolute: as given, and with links followed
};

Result<FileRoot> FileRoot::open(const std::filesystem::path& folder) const {
  if (const Status made = make_folders(folder); !made) return made;
  Result<Descriptor> opened = limited() ? walk(*below(folder), std::nullopt)
                                        : Result<Descriptor>(Descriptor(::open(folder.c_str(), kOpenFolder)));
  if (!opened) return opened.status();
  if (!opened->valid()) return failure(folder, "cannot be opened", errno);
  if (::faccessat(opened->get(), ".", W_OK | X_OK, AT_EACCESS) != 0)
    return failure(folder, "cannot be written to", errno);
  std::error_code ignored;
  FileRoot root;
  root.held_ = std::make_shared<const LimitedFolder>(
      LimitedFolder{std::move(*opened), folder, {plain(folder), plain(std::filesystem::canonical(folder, ignored))}});
  return root;
}

const std::filesystem::path& FileRoot::folder() const {
  static const std::filesystem::path none;
  return limited() ? held_->given : none;
}

bool FileRoot::contains(const std::filesystem::path& path) const { return !limited() || below(path); }

// Returns the path relative to the folder; nothing for the folder itself.
std::optional<std::filesystem::path> FileRoot::below(const std::filesystem::path& path) const {
  const std::filesystem::path inner = plain(path);
  for (const std::filesystem::path& outer : held_->names) {
    auto [at, rest] = std::mismatch(outer.begin(), outer.end(), inner.begin(), inner.end());
    if (at != outer.end()) continue;
    std::filesystem::path relative;
    for (; rest != inner.end(); ++rest) relative /= *rest;
    return relative;
  }
  return std::nullopt;
}

Status FileRoot::link_refused(const std::filesystem::path& path) const {
  return {Code::refused,
          fmt::format("{}: is a symbolic link; this run writes only below {}", path.string(), folder().string())};
}

Status FileRoot::outside(const std::filesystem::path& path) const {
  return {Code::refused, fmt::format("{}: this run writes only below {}", path.string(), folder().string())};
}

// Opens each folder relative to the previous one, and never through a link. `make`: creates missing ones with that
// mode.
Result<Descriptor> FileRoot::walk(const std::filesystem::path& relative, std::optional<unsigned> make) const {
  std::filesystem::path now = held_->given;
  Descriptor folder(::openat(held_->opened.get(), ".", kOpenFolder));
  for (const std::filesystem::path& part : relative) {
    if (!folder.valid()) break;
    now /= part;
    if (make && ::mkdirat(folder.get(), part.c_str(), static_cast<mode_t>(*make)) != 0 && errno != EEXIST)
      return failure(now, "cannot be made", errno);
    if (is_link(folder.get(), part.c_str())) return link_refused(now);
    folder = Descriptor(::openat(folder.get(), part.c_str(), kOpenFolder | O_NOFOLLOW));
  }
  if (!folder.valid()) return failure(now, make ? "cannot be made" : "open of the folder", errno);
  return folder;
}

Result<FileLocation> FileRoot::locate(const std::filesystem::path& path) const {
  if (!limited()) return locate_anywhere(path);
  const auto relative = below(path);
  if (!relative) return outside(path);
  Result<Descriptor> opened = walk(relative->parent_path(), std::nullopt);
  if (!opened) return opened.status();
  return FileLocation{std::move(*opened), relative->empty() ? "." : relative->filename().string()};
}

Status FileRoot::make_folders(const std::filesystem::path& folder, unsigned mode) const {
  if (!limited()) return base::make_folders(folder, mode);
  const auto relative = below(folder);
  if (!relative) return outside(folder);
  return walk(*relative, mode).status();
}

NewFile::~NewFile() {
  if (!placed_ && place_.folder.valid()) ::unlinkat(folder(), temporary_.c_str(), 0);
}

bool NewFile::write(std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t wrote = ::write(file_.get(), bytes.data(), bytes.size());
    if (wrote < 0 && errno != EINTR) return false;
    bytes.remove_prefix(static_cast<std::size_t>(std::max<ssize_t>(wrote, 0)));
  }
  return true;
}

bool NewFile::put_in_place() {
  struct stat named {
  }, own{};
  if (file_.valid()) {
    if (::fstat(file_.get(), &own) != 0 || ::fstatat(folder(), temporary_.c_str(), &named, AT_SYMLINK_NOFOLLOW) != 0)
      return false;
    if (named.st_dev != own.st_dev || named.st_ino != own.st_ino) return errno = ESTALE, false;
  }
  placed_ = ::renameat(folder(), temporary_.c_str(), folder(), place_.name.c_str()) == 0;
  return placed_;
}

Files Files::with(FileRoot root) const {
  Files files(std::move(root));
  files.faults_ = faults_;
  return files;
}

void Files::inject(IoOperation operation, int nth) { (*faults_)[static_cast<std::size_t>(operation)] = nth; }

bool Files::fails(IoOperation operation) {
  int& count = (*faults_)[static_cast<std::size_t>(operation)];
  if (count == 0 || --count > 0) return false;
  errno = EIO;
  return true;
}

Result<std::string> Files::read(const std::filesystem::path& path, std::size_t limit) {
  // O_NONBLOCK: opening a FIFO must not wait for a writer.
  Descriptor file(fails(IoOperation::open) ? -1 : ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
  if (!file.valid()) {
    const int error = errno;
    return failure(path, "cannot be opened", error, code_of_open(error));
  }
  struct stat info {};
  if (::fstat(file.get(), &info) != 0) return failure(path, "cannot be examined", errno);
  if (S_ISDIR(info.st_mode)) return Status{Code::bad_file, path.string() + ": is a directory, expected a file"};
  if (!S_ISREG(info.st_mode)) return Status{Code::bad_file, path.string() + ": is not a regular file"};
  const Status too_large{Code::bad_file, fmt::format("{}: is larger than the limit of {} bytes", path.string(), limit)};
  if (static_cast<std::uint64_t>(info.st_size) > limit) return too_large;

  std::string bytes;
  std::array<char, 65536> chunk;
  for (;;) {
    const ssize_t got = fails(IoOperation::read) ? -1 : ::read(file.get(), chunk.data(), chunk.size());
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) return failure(path, "cannot be read", errno);
    if (got == 0) return bytes;
    bytes.append(chunk.data(), static_cast<std::size_t>(got));
    if (bytes.size() > limit) return too_large;
  }
}

Result<NewFile> Files::create(const std::filesystem::path& path, ReplaceableFiles replaces) {
  // The folder is opened before any change, so that after the rename only its fsync can fail.
  Result<FileLocation> place = root_.locate(path);
  if (!place) return place.status();
  const int folder = place->folder.get();
  const char* const name = place->name.c_str();
  struct stat old {};
  const bool exists = ::fstatat(folder, name, &old, AT_SYMLINK_NOFOLLOW) == 0;
  if (exists && S_ISLNK(old.st_mode)) return root_.link_refused(path);  // without a limit it was followed
  if (exists && !S_ISREG(old.st_mode))
    return Status{Code::io, path.string() + ": is not a regular file, so it cannot be written"};
  if (exists && root_.limited() && replaces == ReplaceableFiles::made && !is_made(made_in(folder), place->name))
    return not_made(path);
  if (exists && ::faccessat(folder, name, W_OK, 0) != 0) return failure(path, "is read-only", errno);
  (void)sweep(folder, temporary_stem(place->name));
  if (fails(IoOperation::open)) return failure(path, "open of the folder", errno);
  std::string temporary;
  Descriptor file = fails(IoOperation::open) ? Descriptor() : open_temporary(*place, temporary);
  if (!file.valid()) return failure(path, "open", errno);
  if (root_.limited()) note_made(folder, place->name);
  NewFile made(std::move(*place), std::move(temporary), std::move(file));
  if (exists && ::fchmod(made.file().get(), old.st_mode & 07777) != 0) return failure(path, "chmod", errno);
  return made;
}

Status Files::write_atomic(const std::filesystem::path& path, std::string_view bytes, ReplaceableFiles replaces) {
  Result<NewFile> made = create(path, replaces);
  if (!made) return made.status();
  Descriptor& file = made->file();
  // From here on every error removes the temporary file and leaves the old one unchanged.
  if (fails(IoOperation::write) || !made->write(bytes)) return failure(path, "write", errno);
  if (fails(IoOperation::fsync) || ::fsync(file.get()) != 0) return failure(path, "fsync", errno);
  if (fails(IoOperation::close) || file.close() != 0) return failure(path, "close", errno);
  if (fails(IoOperation::rename) || !made->put_in_place()) return failure(path, "rename", errno);

  // The new file is in place; without this a power cut could still restore the old one.
  if (fails(IoOperation::fsync) || ::fsync(made->folder()) != 0) return failure(path, "fsync of the folder", errno);
  return {};
}

bool Files::remove(const std::filesystem::path& path) {
  const Result<FileLocation> place = place_itself(root_, path);
  if (place && root_.limited() && !is_made(made_in(place->folder.get()), place->name)) return errno = EPERM, false;
  return place && ::unlinkat(place->folder.get(), place->name.c_str(), 0) == 0;
}

Status Files::remove_made(const std::filesystem::path& folder, const std::function<bool(const std::string&)>& only) {
  COASTER_CHECK(root_.limited(), "files that runs made are known only below a limited root");
  const Result<FileLocation> place = root_.locate(folder / "*");  // opens the folder
  std::error_code ignored;
  if (!place)
    return place.status().code == Code::refused || std::filesystem::exists(folder, ignored) ? place.status() : Status{};
  std::string foreign;
  const auto made = [&](int, const std::string& list, const std::string& name) {
    if ((!only || only(name)) && !is_made(list, name) && !is_trace(list, name)) foreign = name;
    return foreign.empty();
  };
  if (!visit_files(place->folder.get(), !only, made)) return not_made(folder / foreign);
  const auto remove = [&](int inner, const std::string&, const std::string& name) {
    return (only && !only(name)) || ::unlinkat(inner, name.c_str(), 0) == 0;
  };
  if (!visit_files(place->folder.get(), !only, remove)) return failure(folder, "cannot be emptied", errno);
  return {};
}

bool Files::rename(const std::filesystem::path& path, const std::string& name) {
  const Result<FileLocation> place = place_itself(root_, path);
  if (!place || is_there(place->folder.get(), name)) return false;
  if (root_.limited() && is_made(made_in(place->folder.get()), place->name)) note_made(place->folder.get(), name);
  return ::renameat(place->folder.get(), place->name.c_str(), place->folder.get(), name.c_str()) == 0;
}

int Files::remove_leftovers(const std::filesystem::path& target) {
  const Result<FileLocation> place = place_itself(root_, target);
  return place ? sweep(place->folder.get(), temporary_stem(place->name)) : 0;
}

int Files::remove_leftovers_in(const std::filesystem::path& folder) {
  const Result<FileLocation> place = root_.locate(folder / ".coaster");
  return place ? sweep(place->folder.get(), {}) : 0;
}

std::string host_name() {
  char name[256] = "";
  (void)::gethostname(name, sizeof name - 1);
  return name;
}

bool process_runs(std::int64_t pid) {
  return pid > 0 && std::in_range<pid_t>(pid) && (::kill(static_cast<pid_t>(pid), 0) == 0 || errno == EPERM);
}

}  // namespace coaster::base
