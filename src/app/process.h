// Other programs, each in a process of its own that no frame waits for: found in PATH, started by an argument vector,
// so that no shell reads the names, and heard through a pipe.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/status.h"

namespace coaster::app {

// The full path of a program of this name in PATH; empty when there is none that may be run.
std::string find_program(const char* name);

class Process {
 public:
  Process() = default;
  ~Process();
  Process(const Process&) = delete;
  Process& operator=(const Process&) = delete;

  // Starts words[0], a full path, in an open folder (-1: the current one), after ending the one before. Its standard
  // output is read here, its errors, too, when `errors`; there is no input. Code::io with the reason.
  base::Status start(std::vector<std::string> words, int folder = -1, bool errors = false);
  bool running() const { return pid_ > 0; }
  // Takes what there is to read, without waiting; the exit status once it has ended, 128 + N when signal N ended it.
  std::optional<int> poll();
  // What it has written since its start, or since this was emptied.
  std::string& output() { return output_; }
  // Kills it.
  void end();

 private:
  void drain();

  int pid_ = 0, pipe_ = -1;
  std::string output_;
};

}  // namespace coaster::app
