// Force sections: planning 200 m as after a drag in the graph, and its parts.
#include "paired.h"
#include "sim/plan/force_plan.h"

namespace coaster::bench {
namespace force_bench {

// Two hills of 0 g with valleys of 3.5 g between them, at 25 m/s, with a roll of 40 degrees and back: `moved` g at one
// key.
sim::ForceTask task_of(double moved) {
  sim::ForceTask task;
  task.end.position = {0, 40, 0};
  task.losses = {0.02f, 2e-5f};
  task.riders = 1.1;
  world::ForceProgram& program = task.program;
  program.length = 200, program.speed = 25;
  for (const auto& [at, g] : {std::pair{0.0, 1.0},
                              {25.0, 3.0},
                              {50.0, 0.0},
                              {75.0, 0.0},
                              {100.0, 3.5},
                              {125.0, 3.0},
                              {150.0, 0.0},
                              {175.0, 0.5},
                              {200.0, 1.0}})
    program.channels[0].push_back({at, g});
  program.channels[0][4].value += moved;
  for (const auto& [at, roll] : {std::pair{80.0, 0.0}, {100.0, 2.0}, {120.0, 0.0}, {140.0, -2.0}, {160.0, 0.0}})
    program.channels[2].push_back({at, roll});
  return task;
}

void force_plan_200_m(benchmark::State& state) {
  double spans = 0, length = 0;
  int step = 0;
  for (auto _ : state) {
    const sim::ForcePlan plan = sim::plan_force(task_of(0.01 * (++step % 20)));
    spans = static_cast<double>(plan.spans()), length = plan.length;
  }
  state.counters["checksum"] = length, state.counters["spans"] = spans;
}
BENCHMARK(force_plan_200_m)->Unit(benchmark::kMillisecond);

// The same drag with both ends kept.
void force_held_plan_200_m(benchmark::State& state) {
  const sim::ForcePlan still = sim::plan_force(task_of(0));
  const sim::ElementPoint& last = still.path.curve.points.back();
  double spans = 0, unmet = 0;
  int step = 0;
  for (auto _ : state) {
    sim::ForceTask task = task_of(0.01 * (++step % 20));
    task.held = {last.position, last.tangent, last.up, last.curvature, last.spin};
    const sim::ForcePlan plan = sim::plan_force(task);
    spans = static_cast<double>(plan.spans()), unmet = plan.unmet;
  }
  state.counters["checksum"] = unmet, state.counters["spans"] = spans;
}
BENCHMARK(force_held_plan_200_m)->Unit(benchmark::kMillisecond);

void force_path_200_m(benchmark::State& state) {
  int step = 0;
  for (auto _ : state) benchmark::DoNotOptimize(sim::force_path(task_of(0.01 * (++step % 20))).points.size());
}
BENCHMARK(force_path_200_m)->Unit(benchmark::kMillisecond);

}  // namespace force_bench
}  // namespace coaster::bench
