// Long work: how far it is, and its early end on a signal of the system or by Cancel.
#pragma once

#include <atomic>

namespace coaster::base {

struct JobProgress {
  std::atomic<double> done{0};          // 0..1, never decreases; written by the worker
  std::atomic<bool> cancelled{false};   // set by the waiting thread; the worker ends soon after, without a result
  void (*told)(double done) = nullptr;  // also called by report(), where the two have no memory in common

  void report(double part) {
    done = part;
    if (told) told(part);
  }
};

// True if the system has asked the program to end, or the job of this thread is cancelled. Every loop that may take
// more than 0.1 s asks this and ends early. What it has made by then is complete in form and is not used.
bool interrupted();

// Sets the function that says whether the system has asked the program to end. Any thread calls it.
void watch_interruption(bool (*asked)());

// Tells the job of this thread, if it has one, which part is done: 0..1. A smaller part than before changes nothing.
void report_progress(double done);

// The calling thread works for this job as long as the object exists; in_parts() passes it to its other threads.
class JobScope {
 public:
  explicit JobScope(JobProgress* job);
  ~JobScope();
  JobScope(const JobScope&) = delete;
  JobScope& operator=(const JobScope&) = delete;
  static JobProgress* now();  // the thread's job; null for none

 private:
  JobProgress* before_;
};

}  // namespace coaster::base
