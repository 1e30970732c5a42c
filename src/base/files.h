// Reading and atomic writing of whole files, with fault injection for tests. One object owns the injected faults.
#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/root.h"
#include "base/status.h"

namespace coaster::base {

// The operations that can be made to fail; names for scripts are those of the enumerators ("io.fsync").
enum class IoOperation { open, read, write, fsync, rename, close };
inline constexpr std::array<std::string_view, 6> kIoOperationNames{"open", "read", "write", "fsync", "rename", "close"};

inline constexpr std::size_t kMaxFileBytes = 64u << 20;  // larger files are refused

// A new file under a temporary name in the folder of its place. It is removed with this object unless it was put in
// place.
class NewFile {
 public:
  NewFile(Place place, std::string temporary, Descriptor file)
      : place_(std::move(place)), temporary_(std::move(temporary)), file_(std::move(file)) {}
  ~NewFile();
  NewFile(NewFile&&) = default;

  Descriptor& file() { return file_; }
  int folder() const { return place_.folder.get(); }
  const std::string& temporary() const { return temporary_; }  // its name in the folder
  // Renames it over whatever has the name of its place, which is never opened. False with errno.
  bool put_in_place();

 private:
  Place place_;
  std::string temporary_;
  Descriptor file_;
  bool placed_ = false;
};

// Copies share the injected faults and the root. Below a limited root nothing is written, made or removed through a
// link.
class Files {
 public:
  // Without faults.
  explicit Files(Root root = {}) : root_(std::move(root)) {}
  // With the faults of this one.
  Files with(Root root) const;
  const Root& root() const { return root_; }

  // The `nth` call of `operation` from now on fails with EIO (nth = 1 is the next). 0 clears the fault.
  void inject(IoOperation operation, int nth);

  // The whole file. Code::bad_file for missing files, directories, anything but regular files and files over `limit`
  // (message: "PATH: reason"); Code::io when reading breaks off. Reads anywhere.
  Result<std::string> read(const std::filesystem::path& path, std::size_t limit = kMaxFileBytes);

  // Writes a temporary file beside the target, fsync, rename over it, fsync of the folder. Without a limit a symbolic
  // link is followed; with one it is refused. An existing file keeps its mode; one that may not be written, or is not
  // regular, is refused. What runs that were killed left beside the target goes first. On an error the temporary file
  // is gone and the old file is as it was; but when the last step fails (fsync of the folder, the second fsync), the
  // whole new file is in place and may not outlive a power cut. Code::io with "PATH: operation: reason"; Code::refused
  // outside the limit.
  Status write_atomic(const std::filesystem::path& path, std::string_view bytes);
  // The first half of it: for what is written piece by piece, or by another process.
  Result<NewFile> create(const std::filesystem::path& path);

  // Removes a file, or a link rather than what it points to. False when there is none or it cannot be removed.
  bool remove(const std::filesystem::path& path);
  // A folder with all that is in it, or a file; links are removed, not followed. False when something is left.
  bool remove_tree(const std::filesystem::path& path);
  // Gives a file another name in its folder; a link itself is renamed. False when it cannot.
  bool rename(const std::filesystem::path& path, const std::string& name);

  // Removes the temporary files of write_atomic(`target`) whose processes, of this machine, are gone. Returns how many
  // there were.
  int remove_leftovers(const std::filesystem::path& target);
  // The same for every target in a folder.
  int remove_leftovers_in(const std::filesystem::path& folder);

 private:
  using Faults = std::array<int, kIoOperationNames.size()>;  // calls until one fails
  bool fails(IoOperation operation);

  Root root_;
  std::shared_ptr<Faults> faults_ = std::make_shared<Faults>();
};

// Whether a process of this machine runs (or has not been waited for); one of another user counts.
bool process_runs(int pid);
std::string host_name();  // of this machine; empty when it has none

}  // namespace coaster::base
