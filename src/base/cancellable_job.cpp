#include "base/cancellable_job.h"

#include <algorithm>
#include <utility>

namespace coaster::base {
namespace {

std::atomic<bool (*)()> asked_to_end{nullptr};
thread_local JobProgress* job_of_thread = nullptr;

}  // namespace

bool interrupted() {
  bool (*const asked)() = asked_to_end;
  return (asked && asked()) || (job_of_thread && job_of_thread->cancelled);
}

void watch_interruption(bool (*asked)()) { asked_to_end = asked; }

void report_progress(double done) {
  if (job_of_thread) job_of_thread->report(std::max(job_of_thread->done.load(), done));
}

JobScope::JobScope(JobProgress* job) : before_(std::exchange(job_of_thread, job)) {}
JobScope::~JobScope() { job_of_thread = before_; }
JobProgress* JobScope::now() { return job_of_thread; }

}  // namespace coaster::base
