// A long job beside the frames: in a thread; in a page in a worker, which has a copy of the page's memory.
#pragma once

#include <functional>
#include <future>
#include <memory>
#include <string>

#include "app/found.h"
#include "base/interrupted.h"

namespace coaster::app {

class Beside {
 public:
  using Work = std::function<base::Result<Found>()>;

  // Begins. `file` is what the work reads; empty: nothing. Where a page has no worker, take() does the work.
  Beside(Work work, const std::string& file);
  ~Beside();  // cancels; waits for a thread
  Beside(const Beside&) = delete;
  Beside& operator=(const Beside&) = delete;

  // True if beginning takes less than a millisecond: a worker gets a copy of the page's memory first.
  static bool is_quick();
  bool done();                 // without waiting: take() returns at once, or does the work
  base::Result<Found> take();  // once; waits for a thread

  base::Progress progress;

 private:
  std::unique_ptr<Work> work_;  // of a page
  bool in_worker_ = false;      // of a page
  std::future<base::Result<Found>> result_;
};

// Does the work, which `progress` can cancel, and returns. It works in a thread, and after `patience` seconds calls
// `meanwhile` some times a second until it is done. A page has no threads: there it only does the work.
void watch_work(const std::function<void()>& work, base::Progress& progress, double patience,
                const std::function<void()>& meanwhile);

}  // namespace coaster::app
