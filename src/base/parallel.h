// Work split over the processor's cores.
#pragma once

#include <cstddef>
#include <functional>
#include <future>

namespace coaster::base {

// Returns the number of threads that this machine runs at once, at least 1.
unsigned cores();

// How std::async runs work beside the frames: in a thread; where there are none, when its result is asked for.
std::launch beside();

// Calls work(begin, end) for consecutive parts of [0, count) of at most `grain` items, each once, on up to `workers`
// threads, of which the caller's is one; returns when all are done. A single part makes no thread. Where the system
// refuses a thread, the others do its work.
void in_parts(std::size_t count, std::size_t grain, unsigned workers,
              const std::function<void(std::size_t begin, std::size_t end)>& work);

}  // namespace coaster::base
