#include "base/interrupted.h"

#include <utility>

namespace coaster::base {
namespace {

std::atomic<bool (*)()> asked_to_end{nullptr};
thread_local const Progress* job_of_thread = nullptr;

}  // namespace

bool interrupted(const Progress* progress) {
  bool (*const asked)() = asked_to_end;
  return (asked && asked()) || (progress && progress->cancelled) || (job_of_thread && job_of_thread->cancelled);
}

void watch_interruption(bool (*asked)()) { asked_to_end = asked; }

WorkFor::WorkFor(const Progress* job) : before_(std::exchange(job_of_thread, job)) {}
WorkFor::~WorkFor() { job_of_thread = before_; }
const Progress* WorkFor::now() { return job_of_thread; }

}  // namespace coaster::base
