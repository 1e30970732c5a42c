// Reading and atomic writing of whole files, with fault injection for tests. One object owns the injected faults.
#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/status.h"

namespace coaster::base {

// The operations that can be made to fail; names for scripts are those of the enumerators ("io.fsync").
enum class IoOperation { open, read, write, fsync, rename, close };
inline constexpr std::array<std::string_view, 6> kIoOperationNames{"open", "read", "write", "fsync", "rename", "close"};

inline constexpr std::size_t kMaxFileBytes = 64u << 20;  // larger files are refused

class Files {
 public:
  // The `nth` call of `operation` from now on fails with EIO (nth = 1 is the next). 0 clears the fault.
  void inject(IoOperation operation, int nth);

  // The whole file. Code::bad_file for missing files, directories, anything but regular files and files over `limit`
  // (message: "PATH: reason"); Code::io when reading breaks off.
  Result<std::string> read(const std::filesystem::path& path, std::size_t limit = kMaxFileBytes);

  // Writes a temporary file beside the target, fsync, rename over it, fsync of the folder. A symbolic link is followed,
  // an existing file keeps its mode; one that may not be written is refused. What runs that were killed left beside the
  // target goes first. On an error the temporary file is gone and the old file is as it was; but when the last step
  // fails (fsync of the folder, the second fsync), the whole new file is in place and may not outlive a power cut.
  // Code::io with "PATH: operation: reason".
  Status write_atomic(const std::filesystem::path& path, std::string_view bytes);

 private:
  bool fails(IoOperation operation);
  std::array<int, 6> countdown_{};
};

// Removes the temporary files of write_atomic(`target`) whose processes, of this machine, are gone. Returns how many
// there were.
int remove_leftovers(const std::filesystem::path& target);
// The same for every target in a folder.
int remove_leftovers_in(const std::filesystem::path& folder);

// Whether a process of this machine runs (or has not been waited for); one of another user counts.
bool process_runs(int pid);
std::string host_name();  // of this machine; empty when it has none

}  // namespace coaster::base
