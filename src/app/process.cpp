#include "app/process.h"

#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <sstream>
#include <utility>

#include <fmt/format.h>

extern char** environ;

namespace coaster::app {

std::string find_program(const char* name) {
  const char* const path = std::getenv("PATH");
  std::istringstream folders(path != nullptr ? path : "");
  for (std::string folder; std::getline(folders, folder, ':');) {
    const std::filesystem::path file = std::filesystem::path(folder) / name;
    std::error_code failed;
    if (file.is_absolute() && ::access(file.c_str(), X_OK) == 0 && std::filesystem::is_regular_file(file, failed))
      return file.string();
  }
  return {};
}

Process::~Process() { end(); }

base::Status Process::start(std::vector<std::string> words, int folder, bool errors, int file) {
  end();
  output_.clear();
  int ends[2];
  if (words.empty() || ::pipe2(ends, O_CLOEXEC) != 0)
    return {base::Code::io, std::string("no process can be started: ") + std::strerror(errno)};
  ::fcntl(ends[0], F_SETFL, O_NONBLOCK);  // only our end
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_adddup2(&actions, ends[1], STDOUT_FILENO);
  if (errors) posix_spawn_file_actions_adddup2(&actions, ends[1], STDERR_FILENO);
  if (folder >= 0) posix_spawn_file_actions_addfchdir_np(&actions, folder);
  constexpr int kGiven = 3;  // last, because the others may have this number here; loses its O_CLOEXEC
  if (file >= 0) posix_spawn_file_actions_adddup2(&actions, file, kGiven);
  std::vector<char*> argv;
  argv.reserve(words.size() + 1);
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  pid_t pid = 0;
  const int failed = ::posix_spawn(&pid, argv[0], &actions, nullptr, argv.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  ::close(ends[1]);
  if (failed != 0) {
    ::close(ends[0]);
    return {base::Code::io, fmt::format("{}: cannot be started: {}", words[0], std::strerror(failed))};
  }
  pid_ = pid;
  pipe_ = ends[0];
  return {};
}

void Process::drain() {
  char bytes[4096];
  for (ssize_t got; (got = ::read(pipe_, bytes, sizeof bytes)) > 0;)
    output_.append(bytes, static_cast<std::size_t>(got));
}

std::optional<int> Process::poll() {
  if (!running()) return std::nullopt;
  drain();
  int status = 0;
  const pid_t done = ::waitpid(pid_, &status, WNOHANG);
  if (done == 0 || (done < 0 && errno == EINTR)) return std::nullopt;
  drain();  // output written just before the end
  ::close(std::exchange(pipe_, -1));
  pid_ = 0;
  if (done < 0) return 127;
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

void Process::end() {
  if (!running()) return;
  ::kill(pid_, SIGKILL);
  ::waitpid(pid_, nullptr, 0);
  ::close(std::exchange(pipe_, -1));
  pid_ = 0;
}

SystemDialogProcess::SystemDialogProcess() {
  for (const char* const name : {"zenity", "kdialog"})
    if (program_.empty()) program_ = find_program(name);
}

std::vector<std::string> SystemDialogProcess::arguments(const ui::SystemDialogRequest& request) const {
  const std::string start = (std::filesystem::path(request.folder) / request.name).string();
  if (program_.ends_with("kdialog")) return {program_, request.save ? "--getsavefilename" : "--getopenfilename", start};
  std::vector<std::string> words{program_, "--file-selection", "--filename=" + start};
  if (request.save) words.insert(words.end(), {"--save", "--confirm-overwrite"});
  return words;
}

bool SystemDialogProcess::start(const ui::SystemDialogRequest& request) {
  running_ = available() && process_.start(arguments(request)).ok();
  return running_;
}

std::optional<std::string> SystemDialogProcess::poll() {
  const std::optional<int> ended = process_.poll();
  if (!ended) return std::nullopt;
  running_ = false;
  std::string file = std::exchange(process_.output(), {});
  while (file.ends_with('\n')) file.pop_back();
  return *ended == 0 ? file : std::string();
}

}  // namespace coaster::app
