// Work as that of a job that is watched and can be cancelled.
#pragma once

#include "base/cancellable_job.h"

namespace coaster::test {

template <class Work>
auto as_job(base::JobProgress& job, const Work& work) {
  const base::JobScope working(&job);
  return work();
}

}  // namespace coaster::test
