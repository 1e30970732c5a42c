// Tries a graphics driver in a child process first if it may crash: Mesa ends with a signal on an unknown software
// driver.
#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "base/status.h"

namespace coaster::app {

// Returns the set variables that override Mesa's choice of driver or version, as "GALLIUM_DRIVER=swr"; empty without
// any.
std::string driver_overrides();

// Runs `start` in a child process, without its output. Returns its status; Code::graphics with `overrides` in the
// message if it crashed. Only for a process without threads.
base::Status try_driver(const std::function<base::Status()>& start, const std::string& overrides);

// A file that exists while a window starts. If it already exists then, the last start crashed.
class StartMark {
 public:
  // `folder`: the user's state folder. No file is written if it is empty or read-only.
  explicit StartMark(const std::filesystem::path& folder);
  ~StartMark() { remove(); }
  StartMark(const StartMark&) = delete;
  StartMark& operator=(const StartMark&) = delete;

  bool last_crashed() const { return last_crashed_; }
  // Removes the file. Call it when the window has started.
  void remove();

 private:
  std::filesystem::path file_;
  bool last_crashed_ = false;
};

}  // namespace coaster::app
