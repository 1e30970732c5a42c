// Work beside the frames in a thread.
#include "app/long_job.h"

#include <chrono>

#include "base/crash_guard.h"

namespace coaster::app {
namespace {

// Begins work that `progress` can cancel. Where the system refuses a thread, get() does the work: std::async then needs
// it again, so it may not be moved.
template <class Work>
auto begin(const Work& work, base::JobProgress& progress) {
  return std::async(std::launch::async | std::launch::deferred, [work, &progress] {
    const base::HandlerStack stack;
    const base::JobScope cancellable(&progress);
    return work();
  });
}

}  // namespace

BackgroundWork::BackgroundWork(Work work, const std::string&) : result_(begin(work, progress)) {}

BackgroundWork::~BackgroundWork() { progress.cancelled = true; }  // the future waits for the thread
bool BackgroundWork::is_quick() { return true; }
bool BackgroundWork::done() { return result_.wait_for(std::chrono::seconds(0)) != std::future_status::timeout; }
base::Result<JobResult> BackgroundWork::take() { return result_.get(); }

void watch_work(const std::function<void()>& work, base::JobProgress& progress, double patience,
                const std::function<void()>& meanwhile) {
  std::future<void> done = begin(work, progress);
  std::chrono::duration<double> pause(patience);
  for (; done.wait_for(pause) == std::future_status::timeout; meanwhile()) pause = std::chrono::milliseconds(50);
  done.get();
}

}  // namespace coaster::app
