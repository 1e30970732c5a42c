// The paths that scripts may read and write.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "base/files.h"

namespace coaster::script {

// Resolves a path to read. A leading "$OUT" means `out`. Other relative paths are resolved in the script's folder if
// the file exists there, else in the current folder.
std::filesystem::path find_input(const std::filesystem::path& folder, std::string_view written,
                                 const std::filesystem::path& out);

// Returns the message about a path that is not below $OUT, with one that would be.
std::string not_below_out(std::string_view written);

// Resolves a path to write, below the folder of `out`, which is $OUT, and creates its parent folders. Code::usage
// outside it, and the errors of base::Root.
base::Result<std::filesystem::path> find_output(std::string_view written, const base::FileRoot& out);

}  // namespace coaster::script
