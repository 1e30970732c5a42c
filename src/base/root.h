// Where a run may write: anywhere, or only below one folder. A limited run opens every folder on the way by
// descriptor and follows no link, so a prepared link, wherever it points, leads to an error instead of out of
// the folder.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "base/status.h"

namespace coaster::base {

// A file descriptor that closes itself.
class Descriptor {
 public:
  Descriptor() = default;
  explicit Descriptor(int fd) : fd_(fd) {}
  ~Descriptor() { (void)close(); }
  Descriptor(Descriptor&& other) noexcept;
  Descriptor& operator=(Descriptor&& other) noexcept;
  int get() const { return fd_; }
  bool valid() const { return fd_ >= 0; }
  int close();  // 0 or -1 with errno

 private:
  int fd_ = -1;
};

// A file by its open folder and its name there, which need not exist. `name` has no slash; it is "." for a
// folder itself.
struct Place {
  Descriptor folder;
  std::string name;
};

// Copies share the folder's descriptor.
class Root {
 public:
  // No limit: paths mean what they mean to the system, and links are followed.
  Root() = default;

  // The limit `folder`, which is made when it is missing. Without a limit until now its path may hold links;
  // with one it must lie below and hold none. Code::io when it cannot be made, opened or written to.
  Result<Root> open(const std::filesystem::path& folder) const;

  bool limited() const { return held_ != nullptr; }
  const std::filesystem::path& folder() const;  // as given to open(); empty without a limit
  // Whether the text of the path, with ".." resolved, names the folder or something below it. True without a
  // limit.
  bool contains(const std::filesystem::path& path) const;

  // Opens the folder that a path lies in. Code::refused outside the limit or where a folder on the way is a
  // symbolic link; Code::io otherwise.
  Result<Place> locate(const std::filesystem::path& path) const;
  // Makes a folder and those above it, with `mode` less the process's mask. Errors as of locate().
  Status make_folders(const std::filesystem::path& folder, unsigned mode = 0777) const;
  // "PATH: is a symbolic link; this run writes only below FOLDER".
  Status link_refused(const std::filesystem::path& path) const;

 private:
  struct Held;
  std::optional<std::filesystem::path> below(const std::filesystem::path& path) const;
  Result<Descriptor> walk(const std::filesystem::path& relative, std::optional<unsigned> make) const;

  std::shared_ptr<const Held> held_;
};

}  // namespace coaster::base
