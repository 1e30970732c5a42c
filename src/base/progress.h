// How far a long piece of work is, and whether it is still wanted: shared by the thread that works and the one that
// shows it.
#pragma once

#include <atomic>

namespace coaster::base {

struct Progress {
  std::atomic<double> done{0};         // 0..1, never falls; the worker writes
  std::atomic<bool> cancelled{false};  // set by who waits; the worker ends soon after, without a result
};

}  // namespace coaster::base
