// Who is interrupted by what: a signal everybody, Cancel the job's threads alone.
#include "base/interrupted.h"

#include <atomic>

#include <gtest/gtest.h>

#include "base/parallel.h"

namespace coaster::base {
namespace interrupted_test {

TEST(interrupted, cancel_reaches_all_threads_of_its_job_and_no_others) {
  Progress job, other;
  EXPECT_FALSE(interrupted());
  {
    const WorkFor working(&job);
    other.cancelled = true;
    EXPECT_FALSE(interrupted());
    EXPECT_TRUE(interrupted(&other)) << "the one that is named counts, too";
    job.cancelled = true;
    std::atomic<int> parts{0};
    in_parts(64, 1, 4, [&](std::size_t, std::size_t) { parts += interrupted() ? 1 : 0; });
    EXPECT_EQ(parts, 64);
  }
  EXPECT_FALSE(interrupted());
}

TEST(interrupted, a_job_within_a_job_ends_alone) {
  Progress outer, inner;
  const WorkFor first(&outer);
  inner.cancelled = true;
  {
    const WorkFor second(&inner);
    EXPECT_TRUE(interrupted());
  }
  EXPECT_FALSE(interrupted());
  EXPECT_EQ(WorkFor::now(), &outer);
}

TEST(interrupted, a_signal_ends_all_work) {
  watch_interruption([] { return true; });
  EXPECT_TRUE(interrupted());
  Progress job;
  EXPECT_TRUE(interrupted(&job));
  watch_interruption(nullptr);
  EXPECT_FALSE(interrupted());
}

}  // namespace interrupted_test
}  // namespace coaster::base
