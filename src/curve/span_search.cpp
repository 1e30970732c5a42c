#include "curve/span_search.h"

namespace coaster::curve {

std::vector<std::size_t> even_ends(std::span<const std::size_t> ends, std::span<const double> difficulties,
                                   std::size_t count) {
  std::vector<double> sums{0.0};
  for (const double difficulty : difficulties) sums.push_back(sums.back() + difficulty);
  std::vector<std::size_t> even{ends.front()};
  for (std::size_t i = 1, k = 1; i < count; ++i) {
    const double wanted = sums.back() * static_cast<double>(i) / static_cast<double>(count);
    while (k + 1 < sums.size() && sums[k] < wanted) ++k;
    const double share = (wanted - sums[k - 1]) / (sums[k] - sums[k - 1]),
                 many = static_cast<double>(ends[k] - ends[k - 1]);
    const std::size_t end = ends[k - 1] + static_cast<std::size_t>(share * many + 0.5);
    if (end > even.back() && end < ends.back()) even.push_back(end);
  }
  even.push_back(ends.back());
  return even;
}

std::vector<std::size_t> halved(std::span<const std::size_t> ends, std::span<const std::size_t> spans) {
  std::vector<std::size_t> more(ends.begin(), ends.end());
  for (const std::size_t k : spans) more.push_back(ends[k] + (ends[k + 1] - ends[k]) / 2);
  std::sort(more.begin(), more.end());
  more.erase(std::unique(more.begin(), more.end()), more.end());
  return more;
}

}  // namespace coaster::curve
