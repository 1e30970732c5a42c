// Runs work in one thread, for programs without others: in a web page.
#include <algorithm>

#include "base/parallel.h"

namespace coaster::base {

unsigned cores() { return 1; }
bool has_threads() { return false; }

void in_parts(std::size_t count, std::size_t grain, unsigned,
              const std::function<void(std::size_t begin, std::size_t end)>& work) {
  for (std::size_t begin = 0; begin < count; begin += grain) work(begin, std::min(begin + grain, count));
}

}  // namespace coaster::base
