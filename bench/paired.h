// Times a piece of work and its reference alternately, iteration by iteration, so that a ratio compares the same moment
// on the same machine.
#pragma once

#include <benchmark/benchmark.h>

#include <time.h>

#include <algorithm>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace coaster::bench {

using Work = std::function<void()>;

// The counter of a ratio: `of_work` true for time of the work / time of the reference, else the inverse (speed-up).
struct Reference {
  std::string counter;
  Work run;
  bool of_work = true;
};

// Returns the thread's own CPU time, without that of other programs.
inline double thread_seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

inline double seconds(const Work& work) {
  const double before = thread_seconds();
  work();
  benchmark::ClobberMemory();
  return thread_seconds() - before;
}

inline double median(std::vector<double> values) {
  std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2), values.end());
  return values[values.size() / 2];
}

// Runs under Google Benchmark with manual time; one run of the work does `units` things (named by `unit`: "point"). The
// counters are medians over the iterations: `ns_per_UNIT`, and one for each reference.
inline void paired(benchmark::State& state, const std::string& unit, double units, const Work& work,
                   const std::vector<Reference>& references) {
  std::vector<double> times;
  std::vector<std::vector<double>> ratios(references.size());
  work();
  for (auto _ : state) {
    const double time = seconds(work);
    state.SetIterationTime(time);
    times.push_back(time);
    for (std::size_t i = 0; i < references.size(); ++i) {
      const double reference = seconds(references[i].run);
      ratios[i].push_back(references[i].of_work ? time / reference : reference / time);
    }
  }
  if (times.empty()) return;
  work();  // a reference may have overwritten the result that is summed next
  state.counters["ns_per_" + unit] = median(times) * 1e9 / units;
  for (std::size_t i = 0; i < references.size(); ++i) state.counters[references[i].counter] = median(ratios[i]);
}

}  // namespace coaster::bench
