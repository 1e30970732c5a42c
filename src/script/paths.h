// The paths that scripts may read and write.
#pragma once

#include <filesystem>
#include <string_view>

#include "base/status.h"

namespace coaster::script {

// Resolves a path to read. A leading "$OUT" means `out`. Other relative paths are resolved in the script's folder if
// the file exists there, else in the current folder.
std::filesystem::path find_input(const std::filesystem::path& folder, std::string_view written,
                                 const std::filesystem::path& out);

// Resolves a path to write and creates its parent folders. Code::usage unless it lies below $OUT.
base::Result<std::filesystem::path> find_output(std::string_view written, const std::filesystem::path& out);

// True if `path` lies in or below `folder`, after following links.
bool lies_below(const std::filesystem::path& path, const std::filesystem::path& folder);

// Creates the folder. Code::io if that fails or it is not writable.
base::Status make_folder(const std::filesystem::path& folder);

}  // namespace coaster::script
