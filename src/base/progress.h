// Progress of a long task and its cancellation: shared by the thread that works and the one that shows it.
#pragma once

#include <atomic>

namespace coaster::base {

struct Progress {
  std::atomic<double> done{0};          // 0..1, never decreases; written by the worker
  std::atomic<bool> cancelled{false};   // set by the waiting thread; the worker ends soon after, without a result
  void (*told)(double done) = nullptr;  // also called by report(), where the two have no memory in common

  void report(double part) {
    done = part;
    if (told) told(part);
  }
};

}  // namespace coaster::base
