#include "base/folders.h"

#include <sys/stat.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <iterator>

#include <fmt/format.h>

#include "base/files.h"
#include "base/text.h"

namespace coaster::base {
namespace {

std::filesystem::path from_environment(const char* name) {
  const char* const value = std::getenv(name);
  return value != nullptr && value[0] == '/' ? std::filesystem::path(value) : std::filesystem::path();
}

}  // namespace

UserFolders user_folders() {
  const std::filesystem::path home = from_environment("HOME");
  const auto below = [&](const char* name, const char* otherwise) {
    const std::filesystem::path named = from_environment(name);
    if (!named.empty()) return named / "coaster";
    return home.empty() ? std::filesystem::path() : home / otherwise / "coaster";
  };
  return {below("XDG_CONFIG_HOME", ".config"), below("XDG_STATE_HOME", ".local/state")};
}

std::filesystem::path data_folder() {
  if (std::filesystem::path named = from_environment("COASTER_DATA"); !named.empty()) return named;
  std::error_code error;
  const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", error);
  const std::filesystem::path beside =
      program.empty() ? std::filesystem::path() : program.parent_path().parent_path() / "share" / "coaster";
  // The last one is for systems where a program cannot find its own path (no /proc).
  for (const std::filesystem::path& folder :
       {beside, std::filesystem::path(COASTER_SOURCE_DIR), std::filesystem::path("/usr/share/coaster")})
    if (!folder.empty() && std::filesystem::is_directory(folder / "tracks", error)) return folder;
  return {};
}

bool is_installed(const std::filesystem::path& file) {
  const std::filesystem::path data = data_folder();
  std::error_code error;
  if (data.empty() || data == std::filesystem::path(COASTER_SOURCE_DIR)) return false;
  const std::filesystem::path way =
      std::filesystem::weakly_canonical(file, error).lexically_relative(std::filesystem::weakly_canonical(data, error));
  return !error && !way.empty() && *way.begin() != "..";
}

Status make_folders(const std::filesystem::path& folder, unsigned mode) {
  std::error_code error;
  if (std::filesystem::is_directory(folder, error)) return {};
  if (folder.has_parent_path() && folder.parent_path() != folder)
    if (const Status above = make_folders(folder.parent_path(), mode); !above) return above;
  if (::mkdir(folder.c_str(), static_cast<mode_t>(mode)) == 0) return {};
  const int reason = errno;
  if (std::filesystem::is_directory(folder, error)) return {};
  if (std::filesystem::is_symlink(folder, error))
    return {Code::io, fmt::format("{}: is a symbolic link that leads to no folder; expected a folder or a new name",
                                  folder.string())};
  if (reason == EEXIST)
    return {Code::io, fmt::format("{}: is a file; expected a folder or a new name", folder.string())};
  return {Code::io, fmt::format("{}: cannot be made: {}", folder.string(), std::strerror(reason))};
}

Result<std::vector<FolderEntry>> list_folder(const std::filesystem::path& folder, bool hidden) {
  std::vector<FolderEntry> entries;
  std::error_code error;
  std::filesystem::directory_iterator at(folder, error), end;
  for (; !error && at != end; at.increment(error)) {
    struct stat info {};
    const std::string name = at->path().filename().string();
    if ((!hidden && name.starts_with('.')) || name == kMadeList || ::stat(at->path().c_str(), &info) != 0) continue;
    const bool is_folder = S_ISDIR(info.st_mode);
    if (is_folder || S_ISREG(info.st_mode))
      entries.push_back({name, is_folder, is_folder ? 0 : static_cast<std::uintmax_t>(info.st_size),
                         static_cast<std::int64_t>(info.st_mtime)});
  }
  if (error) return Status{Code::bad_file, fmt::format("{}: {}", folder.string(), error.message())};
  std::sort(entries.begin(), entries.end(), [](const FolderEntry& a, const FolderEntry& b) {
    if (a.folder != b.folder) return a.folder;
    const std::string left = lower(a.name), right = lower(b.name);
    return left != right ? left < right : a.name < b.name;
  });
  return entries;
}

std::int64_t change_time(const std::filesystem::path& file) {
  struct stat info {};
  return ::stat(file.c_str(), &info) == 0 ? static_cast<std::int64_t>(info.st_mtime) : 0;
}

std::string local_time(std::int64_t seconds) {
  const std::time_t time = seconds;
  std::tm parts{};
  char text[64] = "";
  if (::localtime_r(&time, &parts) != nullptr) std::strftime(text, sizeof text, "%Y-%m-%d %H:%M", &parts);
  return text;
}

std::string size_text(std::uintmax_t bytes) {
  constexpr const char* kUnits[] = {"B", "kB", "MB", "GB", "TB"};
  double value = static_cast<double>(bytes);
  std::size_t unit = 0;
  while (value >= 999.5 && unit + 1 < std::size(kUnits)) value /= 1000, ++unit;
  return fmt::format("{:.{}f} {}", value, unit > 0 && value < 9.95 ? 1 : 0, kUnits[unit]);
}

}  // namespace coaster::base
