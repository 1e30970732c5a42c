// Who is interrupted by what: a signal everybody, Cancel the job's threads alone.
#include "base/cancellable_job.h"

#include <algorithm>
#include <atomic>

#include <gtest/gtest.h>

#include "base/parallel.h"

namespace coaster::base {
namespace cancellable_job_test {

TEST(interrupted, cancel_reaches_all_threads_of_its_job_and_no_others) {
  JobProgress job, other;
  EXPECT_FALSE(interrupted());
  {
    const JobScope working(&job);
    other.cancelled = true;
    EXPECT_FALSE(interrupted());
    job.cancelled = true;
    std::atomic<int> parts{0};
    in_parts(64, 1, 4, [&](std::size_t, std::size_t) { parts += interrupted() ? 1 : 0; });
    EXPECT_EQ(parts, 64);
  }
  EXPECT_FALSE(interrupted());
}

TEST(interrupted, a_job_within_a_job_ends_alone) {
  JobProgress outer, inner;
  const JobScope first(&outer);
  inner.cancelled = true;
  {
    const JobScope second(&inner);
    EXPECT_TRUE(interrupted());
  }
  EXPECT_FALSE(interrupted());
  EXPECT_EQ(JobScope::now(), &outer);
}

TEST(interrupted, a_job_is_told_how_far_its_work_is_and_it_never_goes_back) {
  report_progress(0.5);  // of no job
  JobProgress job, other;
  const JobScope working(&job);
  for (const double part : {0.2, 0.4, 0.1, 0.6}) {
    const double before = job.done;
    report_progress(part);
    EXPECT_EQ(job.done, std::max(before, part));
  }
  {
    const JobScope unwatched(nullptr);
    report_progress(0.9);
  }
  EXPECT_EQ(job.done, 0.6);
  EXPECT_EQ(other.done, 0.0);
}

TEST(interrupted, a_signal_ends_all_work) {
  watch_interruption([] { return true; });
  EXPECT_TRUE(interrupted());
  watch_interruption(nullptr);
  EXPECT_FALSE(interrupted());
}

}  // namespace cancellable_job_test
}  // namespace coaster::base
