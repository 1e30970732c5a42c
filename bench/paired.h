// Times a piece of work and what it is compared with in turn, iteration by iteration, so that a ratio is of one moment on one machine.
#pragma once

#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace coaster::bench {

using Work = std::function<void()>;

// A ratio's counter: `of_work` true for time of the work / time of the reference, else the other way round (times faster).
struct Reference {
  std::string counter;
  Work run;
  bool of_work = true;
};

inline double seconds(const Work& work) {
  const auto before = std::chrono::steady_clock::now();
  work();
  benchmark::ClobberMemory();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - before).count();
}

inline double median(std::vector<double> values) {
  std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2), values.end());
  return values[values.size() / 2];
}

// Runs under Google Benchmark with manual time; `units` things (named by `unit`: "point") are done by one run of the work. The counters are
// medians over the iterations: `ns_per_UNIT`, and one for each reference.
inline void paired(benchmark::State& state, const std::string& unit, double units, const Work& work, const std::vector<Reference>& references) {
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
  work();  // a reference may have written over the result that is summed up next
  state.counters["ns_per_" + unit] = median(times) * 1e9 / units;
  for (std::size_t i = 0; i < references.size(); ++i) state.counters[references[i].counter] = median(ratios[i]);
}

}  // namespace coaster::bench
