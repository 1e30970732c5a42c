// Completing a circuit: the search for three ways home on an open track with free room, and where every way is blocked.
#include "paired.h"
#include "sim/study/complete_circuit.h"
#include "world/topology.h"

namespace coaster::bench {
namespace {

// Along x, round, and back across itself: the open end is 40 m before the crossing, or 4 m.
world::Document open_track(bool blocked) {
  world::Document document;
  const auto add = [&](glm::vec3 at, glm::vec3 along) {
    world::Knot knot;
    knot.position = at, knot.in_length = knot.out_length = 12;
    world::set_tangent(knot, along);
    world::append_knot(document, knot);
  };
  add({0, 5, 0}, {1, 0, 0}), add({60, 5, 0}, {1, 0, 0}), add({90, 5, 60}, {0, 0, 1}), add({60, 5, 95}, {-1, 0, 0});
  add({30, 5, 70}, {0, 0, -1}), add({30, 5, 40}, {0, 0, -1});
  if (blocked) add({30, 5, 4}, {0, 0, -1});
  return document;
}

void complete(benchmark::State& state, bool blocked) {
  const world::Document document = open_track(blocked);
  const sim::Derived derived = sim::shapes_of(document);
  sim::Conflicts conflicts;
  conflicts.update(derived);
  sim::CircuitTask task = *sim::circuit_task(document, nullptr);
  task.speed = 14, task.coasts = true;
  double sum = 0;
  for (auto _ : state) {
    const sim::CircuitProposals found = sim::complete_circuit(task, derived, conflicts);
    for (const sim::CircuitProposal& proposal : found.list) sum += proposal.plan.length;
  }
  state.counters["checksum"] = sum / static_cast<double>(state.iterations());
}

BENCHMARK_CAPTURE(complete, free, false)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(complete, blocked, true)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace coaster::bench
