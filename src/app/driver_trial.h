// Tries a graphics driver that may crash, in a child process: Mesa dies by a signal on an unknown software driver.
#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "base/status.h"

namespace coaster::app {

// Returns the set variables that override Mesa's choice of driver or version: "GALLIUM_DRIVER=swr"; empty without any.
std::string driver_overrides();

// Runs `start` in a child process, without its output. Returns its status; Code::graphics with `overrides` in the
// message if it crashed. For a process without threads.
base::Status try_driver(const std::function<base::Status()>& start, const std::string& overrides);

// A file that is there while a window starts. If it is there before, the last start crashed.
class StartMark {
 public:
  // `folder`: of the user's state; nothing is marked if it is empty or cannot be written.
  explicit StartMark(const std::filesystem::path& folder);
  ~StartMark() { remove(); }
  StartMark(const StartMark&) = delete;
  StartMark& operator=(const StartMark&) = delete;

  bool last_crashed() const { return last_crashed_; }
  // The window has started.
  void remove();

 private:
  std::filesystem::path file_;
  bool last_crashed_ = false;
};

}  // namespace coaster::app
