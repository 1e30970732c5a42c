// Time per segment of every arc-length method for relative errors of 1e-3, 1e-6, 1e-9 and 1e-12, on track-like and on
// harder cubics, interleaved with adaptive Simpson. Reports the error reached, and whether the tolerance was met.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "../tests/curve/random_cubics.h"  // the sets for which the tests check the tolerance
#include "base/enum_names.h"
#include "curve/arc_length.h"
#include "curve/arc_length_study.h"
#include "paired.h"

namespace coaster::bench {
namespace arc_length_bench {

constexpr std::size_t kSegments = 1000, kHardSegments = 200;
// A timed run has at most this many evaluations (about a millisecond), on fewer segments if each needs many: longer
// runs would be interrupted on a busy machine.
constexpr double kMostEvaluations = 150'000;

struct Set {
  std::string name;
  std::vector<curve::Cubic> cubics;
  std::vector<double> exact;  // m
};

const std::vector<Set>& sets() {
  static const std::vector<Set> all = [] {
    std::vector<Set> made;
    for (const curve::CubicSet& from : curve::cubic_sets(kSegments, 19)) {
      Set set{from.name, from.cubics, {}};
      if (set.name != "track") set.cubics.resize(kHardSegments);
      for (const curve::Cubic& c : set.cubics) set.exact.push_back(static_cast<double>(curve::reference_length(c)));
      made.push_back(std::move(set));
    }
    return made;
  }();
  return all;
}

using Lengths = std::vector<double>;
using StartMeasuring = std::function<void(const Set&, Lengths&)>;

StartMeasuring by_row(std::string_view name, curve::LengthAccuracy demand) {
  const curve::ArcLengthMethod& row = base::row_of(*base::value_named<curve::ArcLengthId>(name));
  return [&row, demand](const Set& set, Lengths& to) {
    for (std::size_t i = 0; i < to.size(); ++i) to[i] = row.measure(set.cubics[i], demand).length;
  };
}

double worst_error(const Set& set, const StartMeasuring& measure) {
  Lengths lengths(set.cubics.size());
  measure(set, lengths);
  double worst = 0;
  for (std::size_t i = 0; i < lengths.size(); ++i)
    worst = std::max(worst, std::abs(lengths[i] - set.exact[i]) / set.exact[i]);
  return worst;
}

double mean_evaluations(const Set& set, std::string_view name, curve::LengthAccuracy demand) {
  const curve::ArcLengthMethod& row = base::row_of(*base::value_named<curve::ArcLengthId>(name));
  double sum = 0;
  for (const curve::Cubic& c : set.cubics) sum += static_cast<double>(row.measure(c, demand).evaluations);
  return sum / static_cast<double>(set.cubics.size());
}

void time_it(benchmark::State& state, const Set& set, const StartMeasuring& measure, double tolerance,
             double evaluations) {
  const curve::LengthAccuracy demand{64, tolerance};
  const StartMeasuring simpson = by_row("simpson_adaptive", demand);
  const double most = std::max(evaluations, mean_evaluations(set, "simpson_adaptive", demand));
  Lengths lengths(std::min(set.cubics.size(), static_cast<std::size_t>(kMostEvaluations / most))),
      others(lengths.size());
  paired(state, "segment", static_cast<double>(lengths.size()), [&] { measure(set, lengths); },
         {{"ratio_to_adaptive_simpson", [&] { simpson(set, others); }, false}});
  const double worst = worst_error(set, measure);
  state.counters["worst_error"] = worst;
  state.counters["error_over_tolerance"] = worst / tolerance;
  if (evaluations > 0) state.counters["evaluations"] = evaluations;
  state.counters["checksum"] = std::accumulate(lengths.begin(), lengths.end(), 0.0);
}

// Returns the smallest count, in steps of about a quarter, with which a counted method meets the tolerance on the whole
// set.
std::optional<int> least_count(const Set& set, std::string_view name, double tolerance) {
  for (int count = 1; count <= 4096; count += std::max(1, count / 4))
    if (worst_error(set, by_row(name, {count, tolerance})) <= tolerance) return count;
  return std::nullopt;
}

void add(const Set& set, const std::string& name, const std::string& digits, const StartMeasuring& measure,
         double tolerance, double evaluations) {
  benchmark::RegisterBenchmark(("arc_length/" + set.name + "/" + name + "/1e-" + digits).c_str(),
                               [&set, measure, tolerance, evaluations](benchmark::State& state) {
                                 time_it(state, set, measure, tolerance, evaluations);
                               })
      ->UseManualTime();
}

// Found when the benchmark runs, because the search takes longer than the benchmark.
void counted(benchmark::State& state, const Set& set, std::string_view name, double tolerance) {
  static std::vector<std::pair<std::string, std::optional<int>>> known;  // for repetitions
  const std::string key = std::string(name) + "/" + std::to_string(tolerance * 1e15);
  auto found = std::find_if(known.begin(), known.end(), [&](const auto& k) { return k.first == key; });
  if (found == known.end()) found = known.insert(known.end(), {key, least_count(set, name, tolerance)});
  if (!found->second) {
    state.SkipWithError("not reached with 4096 intervals");
    return;
  }
  const curve::LengthAccuracy demand{*found->second, tolerance};
  time_it(state, set, by_row(name, demand), tolerance, mean_evaluations(set, name, demand));
}

const bool registered = [] {
  for (const Set& set : sets())
    for (const int digits : {3, 6, 9, 12}) {
      const double tolerance = std::pow(10.0, -digits);
      const std::string to = std::to_string(digits);
      for (const curve::ArcLengthMethod& row : curve::arc_length_methods()) {
        if (row.control == curve::LengthControl::tolerance) {
          if (row.name == "gravesen_adaptive" && (digits > 6 || set.name != "track")) continue;  // milliseconds
          const curve::LengthAccuracy demand{64, tolerance};
          add(set, std::string(row.name), to, by_row(row.name, demand), tolerance,
              mean_evaluations(set, row.name, demand));
        } else if (row.control == curve::LengthControl::count && set.name == "track") {
          benchmark::RegisterBenchmark(
              ("arc_length/track/" + std::string(row.name) + "/1e-" + to).c_str(),
              [&set, name = row.name, tolerance](benchmark::State& state) { counted(state, set, name, tolerance); })
              ->UseManualTime();
        }
      }
      add(
          set, "whole_track", to,
          [tolerance](const Set& of, Lengths& lengths) {
            curve::arc_lengths(std::span(of.cubics).first(lengths.size()), tolerance, lengths);
          },
          tolerance, 0);
    }
  return true;
}();

}  // namespace arc_length_bench
}  // namespace coaster::bench
