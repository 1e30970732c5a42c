#include "app/driver_trial.h"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <string_view>
#include <system_error>

#include <fmt/format.h>

#include "base/folders.h"
#include "base/root.h"

namespace coaster::app {
namespace {

void write_all(int fd, std::string_view text) {
  while (!text.empty()) {
    const ssize_t wrote = ::write(fd, text.data(), text.size());
    if (wrote < 0 && errno != EINTR) return;
    if (wrote > 0) text.remove_prefix(static_cast<std::size_t>(wrote));
  }
}

std::string read_all(int fd) {
  std::string text;
  char bytes[512];
  for (ssize_t got; (got = ::read(fd, bytes, sizeof bytes)) > 0 || (got < 0 && errno == EINTR);)
    if (got > 0) text.append(bytes, static_cast<std::size_t>(got));
  return text;
}

// Runs in the child process: ends with the code of the status, and writes its message.
[[noreturn]] void run_child(const std::function<base::Status()>& start, int answer) {
  if (const int nowhere = ::open("/dev/null", O_WRONLY | O_CLOEXEC); nowhere >= 0)
    for (const int fd : {STDOUT_FILENO, STDERR_FILENO}) (void)::dup2(nowhere, fd);
  const base::Status status = start();
  write_all(answer, status.message);
  std::_Exit(static_cast<int>(status.code));
}

}  // namespace

std::string driver_overrides() {
  std::string found;
  for (char** variable = environ; variable != nullptr && *variable != nullptr; ++variable) {
    const std::string_view text = *variable, name = text.substr(0, text.find('='));
    const bool overrides =
        name == "GALLIUM_DRIVER" || (name.starts_with("MESA_") && name.find("OVERRIDE") != std::string_view::npos);
    if (overrides && text.size() > name.size() + 1) found += fmt::format("{}{}", found.empty() ? "" : " ", text);
  }
  return found;
}

base::Status try_driver(const std::function<base::Status()>& start, const std::string& overrides) {
  int ends[2];
  if (::pipe2(ends, O_CLOEXEC) != 0) return {};
  base::Descriptor reads(ends[0]), writes(ends[1]);
  const pid_t child = ::fork();
  if (child < 0) return {};
  if (child == 0) run_child(start, writes.get());
  (void)writes.close();
  std::string message = read_all(reads.get());
  int result = 0;
  while (::waitpid(child, &result, 0) < 0 && errno == EINTR) {
  }
  const std::string with = overrides.empty() ? "" : fmt::format(" with {}; unset it", overrides);
  if (WIFSIGNALED(result))
    return {base::Code::graphics, fmt::format("the OpenGL driver crashes ({}){}", ::strsignal(WTERMSIG(result)), with)};
  if (WEXITSTATUS(result) == 0) return {};
  return {base::Code::graphics, message.empty() ? fmt::format("the OpenGL driver ends the program{}", with) : message};
}

StartMark::StartMark(const std::filesystem::path& folder) {
  if (folder.empty() || !base::make_folders(folder)) return;
  file_ = folder / "starting";
  std::error_code ignored;
  last_crashed_ = std::filesystem::exists(file_, ignored);
  (void)base::Descriptor(::open(file_.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0600));
}

void StartMark::remove() {
  std::error_code ignored;
  if (!file_.empty()) std::filesystem::remove(file_, ignored);
  file_.clear();
}

}  // namespace coaster::app
