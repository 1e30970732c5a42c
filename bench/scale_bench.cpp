// Very long tracks: processor time and memory for opening one, and for an undo step. Each size is measured in a child
// process, so that memory is what it adds to the process.
#include <benchmark/benchmark.h>

#include <malloc.h>

#include <array>
#include <string>

#include "bench_tracks.h"
#include "child.h"
#include "edit/commands/commands_document.h"
#include "edit/commands/commands_shape.h"
#include "edit/perform/apply.h"
#include "edit/session/session.h"
#include "exchange/own/track_file.h"
#include "sim/shape/rail_tables.h"
#include "sim/shape/shape_distance.h"
#include "sim/solids/conflicts.h"

namespace coaster {
namespace scale_bench {

enum Part { parse, derive, chords, conflicts, tables, command, parts };
constexpr std::array<const char*, parts> kNames{"parse", "derive", "chord_error", "conflicts", "tables", "command"};
struct Figures {
  std::array<double, parts> seconds{}, mb{};
  double undo_kb_few = 0, undo_kb_all = 0;
};

// Measures one part and adds its cost.
void part(Figures& figures, Part part, auto work) {
  malloc_trim(0);  // so that memory freed by an earlier part does not count as available
  const double seconds = bench::cpu_seconds(), mb = bench::resident_mb();
  work();
  figures.seconds[part] = bench::cpu_seconds() - seconds, figures.mb[part] = bench::resident_mb() - mb;
}

Figures measure(const std::string& text) {
  Figures figures;
  edit::Session session = edit::make_session({});
  base::Files files;
  part(figures, parse, [&] { session.document = std::move(exchange::parse_track(text, "bench")->document); });
  part(figures, derive, [&] { sim::derive(session.document, session.settings, {}, session.derived); });
  part(figures, chords, [&] {
    double worst = 0;
    for (const world::Entity segment : session.derived.order)
      worst = sim::chord_error(session.derived.shape(segment).key.cubic, curve::kMaxSteps, worst);
    benchmark::DoNotOptimize(worst);
  });
  sim::reset(session.document, session.derived, session.motion);
  sim::Conflicts found;
  part(figures, conflicts, [&] { benchmark::DoNotOptimize(found.update(session.derived).size()); });
  sim::RailTables rails;
  part(figures, tables, [&] { rails.update(session.derived, world::riders_height(session.document)); });
  part(figures, command, [&] {
    (void)edit::apply(session, files, edit::MoveKnot{{{world::EntityKind::knot, 500}}, {1, 2, 3}});
  });
  figures.undo_kb_few = static_cast<double>(session.history.bytes) / 1e3;
  (void)edit::apply(session, files, edit::Reverse{});
  figures.undo_kb_all = static_cast<double>(session.history.bytes) / 1e3 - figures.undo_kb_few;
  return figures;
}

void scale(benchmark::State& state) {
  const std::string text = exchange::print_track(bench::circuit(static_cast<int>(state.range(0))));
  Figures figures;
  for (auto _ : state) {
    if (!bench::in_child(figures, [&] { return measure(text); }))
      return state.SkipWithError("the measurement ended early");
  }
  for (std::size_t i = 0; i < parts; ++i) {
    state.counters[std::string("cpu_s_") + kNames[i]] = figures.seconds[i];
    if (i != command) state.counters[std::string("mb_") + kNames[i]] = figures.mb[i];
  }
  state.counters["ratio_chord_error_to_derive"] = figures.seconds[chords] / figures.seconds[derive];
  state.counters["kb_undo_of_one_knot"] = figures.undo_kb_few;
  state.counters["kb_undo_of_all_knots"] = figures.undo_kb_all;
}

BENCHMARK(scale)->Arg(1000)->Arg(5000)->Arg(20000)->Arg(100000)->Unit(benchmark::kMillisecond)->Iterations(1);

}  // namespace scale_bench
}  // namespace coaster
