// Long work: how far it is, and its early end on a signal of the system or by Cancel.
#pragma once

#include "base/progress.h"

namespace coaster::base {

// True if the system has asked the program to end, or the job of this thread is cancelled. Every loop that may take
// more than 0.1 s asks this and ends early. What it has made by then is complete in form and is not used.
bool interrupted();

// Sets the function that says whether the system has asked the program to end. Any thread calls it.
void watch_interruption(bool (*asked)());

// Tells the job of this thread, if it has one, which part is done: 0..1. A smaller part than before changes nothing.
void report_progress(double done);

// The calling thread works for this job as long as the object exists; in_parts() passes it to its other threads.
class WorkFor {
 public:
  explicit WorkFor(Progress* job);
  ~WorkFor();
  WorkFor(const WorkFor&) = delete;
  WorkFor& operator=(const WorkFor&) = delete;
  static Progress* now();  // the thread's job; null for none

 private:
  Progress* before_;
};

}  // namespace coaster::base
