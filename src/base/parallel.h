// Splits work over the processor's cores.
#pragma once

#include <cstddef>
#include <functional>

namespace coaster::base {

// Returns the number of threads that this machine runs at once, at least 1.
unsigned cores();

// True if work can run in another thread; elsewhere std::async has to defer it until its result is requested.
bool has_threads();

// Calls work(begin, end) for consecutive parts of [0, count) of at most `grain` items, each once, on up to `workers`
// threads including the caller's; returns when all are done. A single part starts no thread. If the system refuses a
// thread, the others do its work.
void in_parts(std::size_t count, std::size_t grain, unsigned workers,
              const std::function<void(std::size_t begin, std::size_t end)>& work);

}  // namespace coaster::base
