// Completing a circuit: the search for three closing sections on an open track with free space, where every way is
// blocked, and on random tracks; and a change of a circuit of 40 elements, to which the completing section adapts.
#include <cmath>
#include <random>

#include <fmt/format.h>

#include "edit/commands/codec.h"
#include "edit/perform/apply.h"
#include "edit/session/findings_memory.h"
#include "paired.h"
#include "sim/study/complete_circuit.h"
#include "world/topology.h"

namespace coaster::bench {
namespace circuit_bench {

// Returns a track along x, round a turn, and back across itself: the open end is 40 m before the crossing, or 4 m.
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
  const sim::DerivedTrack derived = sim::shapes_of(document);
  sim::Conflicts conflicts;
  conflicts.update(derived);
  sim::CircuitTask task = *sim::circuit_task(document, derived, nullptr);
  task.speed = 14, task.coasts = true;
  double sum = 0;
  for (auto _ : state) {
    const sim::CircuitProposals found = sim::complete_circuit(task, derived, conflicts);
    for (const sim::CircuitProposal& proposal : found.list) sum += proposal.plan.length;
  }
  state.counters["checksum"] = sum / static_cast<double>(state.iterations());
}

struct Builder {
  edit::Session session = edit::make_session({});
  base::Files files;
  bool apply(const std::string& line) {
    std::vector<base::Token> tokens;
    base::TextError error;
    if (!base::tokenise(line, tokens, error)) return false;
    const auto command = edit::parse(tokens, error);
    return command && edit::apply(session, files, *command);
  }
};

// A station, a lift and up to eight elements.
void build_random(std::uint32_t seed, Builder& builder) {
  std::mt19937 bits(seed);
  const auto uniform = [&](double low, double high) { return low + (high - low) * (bits() / 4294967296.0); };
  builder.apply("element straight length 30 equipment station");
  builder.apply(fmt::format("element climb height {:.0f} equipment lift", uniform(15, 40)));
  builder.apply(fmt::format("element dive height {:.0f}", uniform(10, 30)));
  for (std::uint32_t left = bits() % 8; left > 0; --left) {
    const char* const side = bits() % 2 ? "left" : "right";
    const std::string lines[] = {
        fmt::format("element straight length {:.0f}", uniform(5, 60)),
        fmt::format("element curve {} radius {:.0f} angle {:.0f}", side, uniform(15, 50), uniform(20, 200)),
        fmt::format("element camelback height {:.0f} speed 18", uniform(4, 10)),
        fmt::format("element helix {} radius 18 turns 1.2 height 6", side)};
    builder.apply(lines[bits() % 4]);
  }
}

void complete_random(benchmark::State& state) {
  Builder builder;
  build_random(static_cast<std::uint32_t>(state.range(0)), builder);
  edit::Session& session = builder.session;
  const edit::SessionFindings find(session);
  (void)find.conflicts();
  const sim::CircuitTask task = *sim::circuit_task(session.document, session.derived, find.ride());
  std::size_t proposals = 0;
  for (auto _ : state)
    proposals = sim::complete_circuit(task, session.derived, session.findings->conflicts).list.size();
  state.counters["proposals"] = static_cast<double>(proposals);
}
BENCHMARK(complete_random)->DenseRange(1, 20)->Unit(benchmark::kMillisecond);

// Two turns and hills between them, 40 elements in total. A drag changes a lift, and everything that depends on it is
// updated.
void change_40_elements(benchmark::State& state) {
  Builder builder;
  builder.apply("element straight length 30 equipment station");
  builder.apply("element climb height 45 equipment lift");
  builder.apply("element dive height 40");
  for (int leg = 0; leg < 2; ++leg) {
    for (int i = 0; i < 16; ++i)
      builder.apply(i % 2 ? "element camelback height 8 speed 26" : "element straight length 8");
    builder.apply(fmt::format("element curve left radius {} angle 180 bank 50", 60 + 25 * leg));
  }
  builder.apply("element straight length 60 equipment brake speed 8");
  builder.apply("element straight length 20");
  const bool closed = builder.apply("complete 1");
  edit::Session& session = builder.session;
  builder.apply("gesture.begin");
  int step = 0, taken = 0;
  for (auto _ : state) {
    taken += builder.apply(
        fmt::format("section.change @q2 from_start on to climb height {} equipment lift", 45 + 0.05 * (++step % 40)));
    (void)edit::SessionFindings(session).overloads(), (void)edit::SessionFindings(session).conflicts();
  }
  state.counters["closed"] = closed;
  state.counters["sections"] = static_cast<double>(session.document.entities.pool<world::Section>().size());
  state.counters["segments"] = static_cast<double>(session.document.track.segments.size());
  state.counters["taken"] = static_cast<double>(taken) / static_cast<double>(state.iterations());
}
BENCHMARK(change_40_elements)->Unit(benchmark::kMillisecond);

BENCHMARK_CAPTURE(complete, free, false)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(complete, blocked, true)->Unit(benchmark::kMillisecond);

}  // namespace circuit_bench
}  // namespace coaster::bench
