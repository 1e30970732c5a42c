// Where scripts may read and write.
#pragma once

#include <filesystem>
#include <string_view>

#include "base/status.h"

namespace coaster::script {

// "$OUT" at the front stands for `out`. Other relative paths: from the script's folder when something is there, else
// from the current folder.
std::filesystem::path find_input(const std::filesystem::path& folder, std::string_view written,
                                 const std::filesystem::path& out);

// A path to write to. Code::usage unless it lies below $OUT; the folders up to it are made.
base::Result<std::filesystem::path> find_output(std::string_view written, const std::filesystem::path& out);

// True when `path` lies in `folder` or below, links followed.
bool lies_below(const std::filesystem::path& path, const std::filesystem::path& folder);

// Makes the folder. Code::io when that fails or nothing can be written into it.
base::Status make_folder(const std::filesystem::path& folder);

}  // namespace coaster::script
