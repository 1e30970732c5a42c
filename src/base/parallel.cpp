#include "base/parallel.h"
#include "base/cancellable_job.h"

#include <algorithm>
#include <atomic>
#include <system_error>
#include <thread>
#include <vector>

#include "base/crash_guard.h"

namespace coaster::base {

bool has_threads() { return true; }

unsigned cores() {
  static const unsigned count = std::max(1u, std::thread::hardware_concurrency());  // the call takes 0.1 ms
  return count;
}

void in_parts(std::size_t count, std::size_t grain, unsigned workers,
              const std::function<void(std::size_t begin, std::size_t end)>& work) {
  std::atomic<std::size_t> next{0};
  const auto take_parts = [&, job = JobScope::now()] {
    const JobScope same_job(job);
    for (std::size_t begin = 0; (begin = next.fetch_add(grain)) < count;) work(begin, std::min(begin + grain, count));
  };
  const std::size_t parts = (count + grain - 1) / grain;
  std::vector<std::jthread> others;  // joined at the end of the scope
  try {
    while (others.size() + 1 < std::min<std::size_t>(workers, parts))
      others.emplace_back([&] {
        const HandlerStack stack;
        take_parts();
      });
  } catch (const std::system_error&) {
  }
  take_parts();
}

}  // namespace coaster::base
