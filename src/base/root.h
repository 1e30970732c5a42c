// The limit on where a run may write: anywhere, or only below one folder. A limited run opens every folder on the path
// by descriptor and follows no link, so a prepared link gives an error and never leads out of the folder.
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

// A file as its open folder and its name there, which need not exist. `name` contains no slash; it is "." for a folder
// itself.
struct Place {
  Descriptor folder;
  std::string name;
};

// Copies share the folder's descriptor.
class Root {
 public:
  // No limit: paths have their usual meaning, and links are followed.
  Root() = default;

  // Returns a root limited to `folder`, which is created if missing. If there is no limit yet, its path may contain
  // links; otherwise it must lie below the present limit and contain none. Code::io if it cannot be created, opened or
  // written.
  Result<Root> open(const std::filesystem::path& folder) const;

  bool limited() const { return held_ != nullptr; }
  const std::filesystem::path& folder() const;  // as given to open(); empty without a limit
  // True if the text of the path, with ".." resolved, is the folder or below it. True without a limit.
  bool contains(const std::filesystem::path& path) const;

  // Opens the folder of a path. Code::refused outside the limit or if a folder on the path is a symbolic link; Code::io
  // otherwise.
  Result<Place> locate(const std::filesystem::path& path) const;
  // Creates a folder and its parents, with `mode` less the process's mask. Errors as locate().
  Status make_folders(const std::filesystem::path& folder, unsigned mode = 0777) const;
  // Returns "PATH: is a symbolic link; this run writes only below FOLDER".
  Status link_refused(const std::filesystem::path& path) const;

 private:
  struct Held;
  Status outside(const std::filesystem::path& path) const;
  std::optional<std::filesystem::path> below(const std::filesystem::path& path) const;
  Result<Descriptor> walk(const std::filesystem::path& relative, std::optional<unsigned> make) const;

  std::shared_ptr<const Held> held_;
};

}  // namespace coaster::base
