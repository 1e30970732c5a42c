// Reads and atomically writes whole files, with fault injection for tests, anywhere or only below one folder. A limited
// run opens every folder on the path by descriptor and follows no link, so a prepared link gives an error and never
// leads out of the folder.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

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
struct FileLocation {
  Descriptor folder;
  std::string name;
};

// Copies share the folder's descriptor.
class FileRoot {
 public:
  // No limit: paths have their usual meaning, and links are followed.
  FileRoot() = default;

  // Returns a root limited to `folder`, which is created if missing. If there is no limit yet, its path may contain
  // links; otherwise it must lie below the present limit and contain none. Code::io if it cannot be created, opened or
  // written.
  Result<FileRoot> open(const std::filesystem::path& folder) const;

  bool limited() const { return held_ != nullptr; }
  const std::filesystem::path& folder() const;  // as given to open(); empty without a limit
  // True if the text of the path, with ".." resolved, is the folder or below it. True without a limit.
  bool contains(const std::filesystem::path& path) const;

  // Opens the folder of a path. Code::refused outside the limit or if a folder on the path is a symbolic link; Code::io
  // otherwise.
  Result<FileLocation> locate(const std::filesystem::path& path) const;
  // Creates a folder and its parents, with `mode` less the process's mask. Errors as locate().
  Status make_folders(const std::filesystem::path& folder, unsigned mode = 0777) const;
  // Returns "PATH: is a symbolic link; this run writes only below FOLDER".
  Status link_refused(const std::filesystem::path& path) const;

 private:
  struct LimitedFolder;
  Status outside(const std::filesystem::path& path) const;
  std::optional<std::filesystem::path> below(const std::filesystem::path& path) const;
  Result<Descriptor> walk(const std::filesystem::path& relative, std::optional<unsigned> make) const;

  std::shared_ptr<const LimitedFolder> held_;
};

// The operations that can be made to fail; scripts use the enumerators' names ("io.fsync").
enum class IoOperation { open, read, write, fsync, rename, close };
inline constexpr std::array<std::string_view, 6> kIoOperationNames{"open", "read", "write", "fsync", "rename", "close"};
inline constexpr std::size_t kMaxFileBytes = 64u << 20;  // larger files are rejected

// A new file under a temporary name in its target folder. Removed with this object unless it was put in place.
class NewFile {
 public:
  NewFile(FileLocation place, std::string temporary, Descriptor file)
      : place_(std::move(place)), temporary_(std::move(temporary)), file_(std::move(file)) {}
  ~NewFile();
  NewFile(NewFile&&) = default;

  Descriptor& file() { return file_; }
  int folder() const { return place_.folder.get(); }
  // Appends bytes. Returns false with errno.
  bool write(std::string_view bytes);
  // Renames it over the target name, whose old file is never opened. Returns false with errno: ESTALE if another file,
  // or a link, has taken the temporary name of a file that is still open.
  bool put_in_place();

 private:
  FileLocation place_;
  std::string temporary_;
  Descriptor file_;
  bool placed_ = false;
};

// What a file may replace where a run writes only below a folder: files that runs made there, or any.
enum class ReplaceableFiles { made, any };

// The file in each folder that lists the files that runs with a limited root made in it.
inline constexpr std::string_view kMadeList = ".coaster-made";

// Copies share the injected faults and the root. With a limited root nothing is written, created or removed through a
// link, and only files that runs made are replaced or removed: kMadeList names them.
class Files {
 public:
  // Creates an object without injected faults.
  explicit Files(FileRoot root = {}) : root_(std::move(root)) {}
  // Returns a copy with another root and the same injected faults.
  Files with(FileRoot root) const;
  const FileRoot& root() const { return root_; }

  // Makes the `nth` call of `operation` from now on fail with EIO (nth = 1 is the next). 0 clears the fault.
  void inject(IoOperation operation, int nth);

  // Returns the contents of a file. Code::bad_file for missing files, directories, anything but regular files and files
  // over `limit` (message: "PATH: reason"); Code::io if reading fails. Reads anywhere.
  Result<std::string> read(const std::filesystem::path& path, std::size_t limit = kMaxFileBytes);

  // Writes a temporary file in the target's folder, calls fsync, renames it over the target, and calls fsync on the
  // folder. Without a limited root a symbolic link is followed; with one it is refused. An existing file keeps its
  // mode; read-only and non-regular files are refused. Removes leftovers of killed runs first. On an error the
  // temporary file is removed and the old file is unchanged; but if the last step fails (the second fsync, on the
  // folder), the complete new file is in place and may not survive a power cut. Code::io with "PATH: operation:
  // reason"; Code::refused outside the limit, and for a file below it that may not be replaced.
  Status write_atomic(const std::filesystem::path& path, std::string_view bytes,
                      ReplaceableFiles replaces = ReplaceableFiles::made);
  // Creates the temporary file of write_atomic, for files that are written in pieces or by another process.
  Result<NewFile> create(const std::filesystem::path& path, ReplaceableFiles replaces = ReplaceableFiles::made);

  // Removes a file, or a link itself. Returns false if there is none or it cannot be removed.
  bool remove(const std::filesystem::path& path);
  // Removes all files in a folder below a limited root, and in its folders, if runs made all of them; otherwise removes
  // nothing: Code::refused with the first one that no run made. Ok if there is no such folder. `only`: of the files
  // with these names, and not in its folders.
  Status remove_made(const std::filesystem::path& folder, const std::function<bool(const std::string&)>& only = {});
  // Renames a file within its folder to a name that is free; renames a link itself. Returns false on failure.
  bool rename(const std::filesystem::path& path, const std::string& name);

  // Removes the temporary files of write_atomic(`target`) whose processes, on this machine, have ended. Returns their
  // number.
  int remove_leftovers(const std::filesystem::path& target);
  // Does the same for every target in a folder.
  int remove_leftovers_in(const std::filesystem::path& folder);

 private:
  using Faults = std::array<int, kIoOperationNames.size()>;  // calls until the injected failure
  bool fails(IoOperation operation);

  FileRoot root_;
  std::shared_ptr<Faults> faults_ = std::make_shared<Faults>();
};

// True if a process of this machine is running (or has not been waited for), even if another user owns it.
bool process_runs(std::int64_t pid);
std::string host_name();  // name of this machine; empty if it has none

}  // namespace coaster::base
