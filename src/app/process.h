// Other programs in separate processes that no frame waits for: found in PATH, started with an argument vector, so that
// no shell interprets names, with output read through a pipe.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/status.h"
#include "ui/context/state.h"

namespace coaster::app {

// Returns the full path of an executable of this name in PATH; empty if there is none.
std::string find_program(const char* name);

// The path under which a process finds the open file that it was given. No name leads to it, so no link can replace it.
inline constexpr const char* kGivenFile = "/proc/self/fd/3";

class Process {
 public:
  Process() = default;
  ~Process();
  Process(const Process&) = delete;
  Process& operator=(const Process&) = delete;

  // Starts words[0], a full path, in an open folder (-1: the current one), after ending the previous process. Reads its
  // standard output and, with `errors`, its standard error; it gets no input, and `file` (-1: none) as kGivenFile.
  // Code::io with the reason.
  base::Status start(std::vector<std::string> words, int folder = -1, bool errors = false, int file = -1);
  bool running() const { return pid_ > 0; }
  // Reads the available output without waiting; returns the exit status once it has ended, 128 + N if signal N ended
  // it.
  std::optional<int> poll();
  // Returns its output since its start, or since the string was cleared.
  std::string& output() { return output_; }
  // Kills it.
  void end();

 private:
  void drain();

  int pid_ = 0, pipe_ = -1;
  std::string output_;
};

class SystemDialogProcess {
 public:
  // Looks for the programs in PATH.
  SystemDialogProcess();

  bool available() const { return !program_.empty(); }
  bool running() const { return running_; }
  // Ends the previous dialog. Returns false if it cannot be started.
  bool start(const ui::SystemDialogRequest& request);
  // Polls without waiting: returns the chosen file once the dialog has ended, "" if it was cancelled.
  std::optional<std::string> poll();

 private:
  std::vector<std::string> arguments(const ui::SystemDialogRequest& request) const;

  std::string program_;  // full path
  Process process_;
  bool running_ = false;
};

}  // namespace coaster::app
