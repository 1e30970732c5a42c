#include "base/root.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <utility>

#include <fmt/format.h>

#include "base/folders.h"

namespace coaster::base {
namespace {

constexpr int kOpenFolder = O_RDONLY | O_DIRECTORY | O_CLOEXEC;

Status failure(const std::filesystem::path& path, std::string_view what, int error) {
  return {Code::io, fmt::format("{}: {}: {}", path.string(), what, std::strerror(error))};
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

Result<Place> locate_anywhere(std::filesystem::path target) {
  const std::filesystem::path asked = target;
  if (const Status followed = follow_links(target); !followed) return followed;
  const std::filesystem::path folder = target.has_parent_path() ? target.parent_path() : ".";
  Descriptor opened(::open(folder.c_str(), kOpenFolder));
  if (!opened.valid()) return failure(asked, "open of the folder", errno);
  return Place{std::move(opened), target.has_filename() ? target.filename().string() : "."};
}

}  // namespace

Descriptor::Descriptor(Descriptor&& other) noexcept : fd_(std::exchange(other.fd_, -1)) {}

Descriptor& Descriptor::operator=(Descriptor&& other) noexcept {
  if (this != &other) (void)close(), fd_ = std::exchange(other.fd_, -1);
  return *this;
}

int Descriptor::close() { return fd_ < 0 ? 0 : ::close(std::exchange(fd_, -1)); }

struct Root::Held {
  Descriptor opened;
  std::filesystem::path given;
  std::array<std::filesystem::path, 2> names;  // absolute: as given, and with links followed
};

Result<Root> Root::open(const std::filesystem::path& folder) const {
  if (const Status made = make_folders(folder); !made) return made;
  Result<Descriptor> opened = limited() ? walk(*below(folder), std::nullopt)
                                        : Result<Descriptor>(Descriptor(::open(folder.c_str(), kOpenFolder)));
  if (!opened) return opened.status();
  if (!opened->valid()) return failure(folder, "cannot be opened", errno);
  if (::faccessat(opened->get(), ".", W_OK | X_OK, AT_EACCESS) != 0)
    return failure(folder, "cannot be written to", errno);
  std::error_code ignored;
  Root root;
  root.held_ = std::make_shared<const Held>(
      Held{std::move(*opened), folder, {plain(folder), plain(std::filesystem::canonical(folder, ignored))}});
  return root;
}

const std::filesystem::path& Root::folder() const {
  static const std::filesystem::path none;
  return limited() ? held_->given : none;
}

bool Root::contains(const std::filesystem::path& path) const { return !limited() || below(path); }

// Returns the path relative to the folder; nothing for the folder itself.
std::optional<std::filesystem::path> Root::below(const std::filesystem::path& path) const {
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

Status Root::link_refused(const std::filesystem::path& path) const {
  return {Code::refused,
          fmt::format("{}: is a symbolic link; this run writes only below {}", path.string(), folder().string())};
}

Status Root::outside(const std::filesystem::path& path) const {
  return {Code::refused, fmt::format("{}: this run writes only below {}", path.string(), folder().string())};
}

// Opens each folder relative to the previous one, and never through a link. `make`: creates missing ones with that
// mode.
Result<Descriptor> Root::walk(const std::filesystem::path& relative, std::optional<unsigned> make) const {
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

Result<Place> Root::locate(const std::filesystem::path& path) const {
  if (!limited()) return locate_anywhere(path);
  const auto relative = below(path);
  if (!relative) return outside(path);
  Result<Descriptor> opened = walk(relative->parent_path(), std::nullopt);
  if (!opened) return opened.status();
  return Place{std::move(*opened), relative->empty() ? "." : relative->filename().string()};
}

Status Root::make_folders(const std::filesystem::path& folder, unsigned mode) const {
  if (!limited()) return base::make_folders(folder, mode);
  const auto relative = below(folder);
  if (!relative) return outside(folder);
  return walk(*relative, mode).status();
}

}  // namespace coaster::base
