// Runs a program by its argument vector: no shell reads the names.
#include "app/system_dialog.h"

#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <utility>

extern char** environ;

namespace coaster::app {
namespace {

std::string in_path(const char* name) {
  const char* const folders = std::getenv("PATH");
  std::string all = folders != nullptr ? folders : "";
  for (std::size_t from = 0; from <= all.size();) {
    const std::size_t to = std::min(all.find(':', from), all.size());
    const std::filesystem::path file = std::filesystem::path(all.substr(from, to - from)) / name;
    if (file.is_absolute() && ::access(file.c_str(), X_OK) == 0) return file.string();
    from = to + 1;
  }
  return {};
}

}  // namespace

SystemDialogProcess::SystemDialogProcess() {
  for (const char* const name : {"zenity", "kdialog"})
    if (program_.empty()) program_ = in_path(name);
}
SystemDialogProcess::~SystemDialogProcess() { end(); }

std::vector<std::string> SystemDialogProcess::arguments(const ui::SystemDialogRequest& request) const {
  const std::string start = (std::filesystem::path(request.folder) / request.name).string();
  if (program_.ends_with("kdialog")) return {program_, request.save ? "--getsavefilename" : "--getopenfilename", start};
  std::vector<std::string> words{program_, "--file-selection", "--filename=" + start};
  if (request.save) words.insert(words.end(), {"--save", "--confirm-overwrite"});
  return words;
}

bool SystemDialogProcess::start(const ui::SystemDialogRequest& request) {
  end();
  int ends[2];
  if (!available() || ::pipe2(ends, O_CLOEXEC) != 0) return false;
  ::fcntl(ends[0], F_SETFL, O_NONBLOCK);  // our end alone
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, ends[1], STDOUT_FILENO);
  std::vector<std::string> words = arguments(request);
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  pid_t pid = 0;
  const int failed = ::posix_spawn(&pid, program_.c_str(), &actions, nullptr, argv.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  ::close(ends[1]);
  if (failed != 0) {
    ::close(ends[0]);
    return false;
  }
  pid_ = pid;
  pipe_ = ends[0];
  output_.clear();
  return true;
}

std::optional<std::string> SystemDialogProcess::poll() {
  if (!running()) return std::nullopt;
  const auto drain = [&] {
    char bytes[4096];
    for (ssize_t got; (got = ::read(pipe_, bytes, sizeof bytes)) > 0;) output_.append(bytes, static_cast<std::size_t>(got));
  };
  drain();
  int status = 0;
  const pid_t done = ::waitpid(pid_, &status, WNOHANG);
  if (done == 0 || (done < 0 && errno == EINTR)) return std::nullopt;
  drain();  // what it wrote just before it ended
  ::close(std::exchange(pipe_, -1));
  pid_ = 0;
  while (output_.ends_with('\n')) output_.pop_back();
  const bool accepted = done > 0 && WIFEXITED(status) && WEXITSTATUS(status) == 0;
  return accepted ? std::exchange(output_, {}) : std::string();
}

void SystemDialogProcess::end() {
  if (!running()) return;
  ::kill(pid_, SIGKILL);
  ::waitpid(pid_, nullptr, 0);
  ::close(std::exchange(pipe_, -1));
  pid_ = 0;
}

}  // namespace coaster::app
