#include "base/made_files.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>

#include <fmt/format.h>

#include "base/files.h"

namespace coaster::base {
namespace {

// Opens the list of the files that runs made in a folder; invalid if something else has its name.
Descriptor open_list(int folder, int flags) {
  Descriptor list(::openat(folder, kMadeList.data(), flags | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC, 0666));
  struct stat info {};
  const bool own = ::fstat(list.get(), &info) == 0 && S_ISREG(info.st_mode) && info.st_nlink == 1;
  return own ? std::move(list) : Descriptor();
}

}  // namespace

bool is_there(int folder, const std::string& name) {
  struct stat info {};
  return ::fstatat(folder, name.c_str(), &info, AT_SYMLINK_NOFOLLOW) == 0;
}

std::string made_in(int folder) {
  const Descriptor list = open_list(folder, O_RDONLY);
  std::string text = "\n";
  std::array<char, 65536> chunk;
  for (ssize_t got = 0; (got = ::read(list.get(), chunk.data(), chunk.size())) > 0;)
    text.append(chunk.data(), static_cast<std::size_t>(got));
  return text;
}
bool is_made(const std::string& list, std::string_view name) {
  return name.find('\n') == std::string_view::npos && list.find(fmt::format("\n{}\n", name)) != std::string::npos;
}

void note_made(int folder, const std::string& name) {
  if (name.find('\n') != std::string::npos || is_made(made_in(folder), name)) return;
  const std::string line = name + '\n';
  const Descriptor list = open_list(folder, O_WRONLY | O_CREAT | O_APPEND);
  (void)!::write(list.get(), line.data(), line.size());
}

}  // namespace coaster::base
