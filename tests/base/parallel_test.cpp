#include "base/parallel.h"

#include <algorithm>
#include <atomic>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

namespace coaster::base {
namespace parallel_test {

TEST(parallel, every_item_is_worked_on_once) {
  for (const std::size_t count : {0u, 1u, 63u, 64u, 65u, 1000u})
    for (const unsigned workers : {1u, 2u, 7u, 100u}) {
      std::vector<std::atomic<int>> times(count);
      in_parts(count, 64, workers, [&](std::size_t begin, std::size_t end) {
        EXPECT_LT(begin, end);
        EXPECT_LE(end - begin, 64u);
        for (std::size_t i = begin; i < end; ++i) ++times[i];
      });
      EXPECT_TRUE(std::all_of(times.begin(), times.end(), [](const auto& n) { return n == 1; })) << count;
    }
}

TEST(parallel, one_part_or_one_worker_stays_on_the_callers_thread) {
  const std::thread::id here = std::this_thread::get_id();
  const auto stays = [&](std::size_t, std::size_t) { EXPECT_EQ(std::this_thread::get_id(), here); };
  in_parts(64, 64, 7, stays);
  in_parts(1000, 10, 1, stays);
}

}  // namespace parallel_test
}  // namespace coaster::base
