// Frames of 5,000 segments at 64 steps, drawn off screen: the processor's work outside OpenGL (panels, commands, derived data, what the cache
// prepares), for a still frame and for one that drags a knot. Beside it a memset of the bytes of all polylines and of those that a drag
// uploads, so that the ratio holds on other machines.
#include <benchmark/benchmark.h>

#include <cmath>
#include <cstring>
#include <vector>

#include "app/frame.h"
#include "app/program.h"
#include "world/topology.h"

namespace coaster {
namespace {

constexpr int kSegments = 5000;

// A closed ring with hills, ten metres a segment.
world::Document ring() {
  world::Document document;
  const double radius = kSegments * 10 / 6.283185307179586;
  for (int i = 0; i < kSegments; ++i) {
    const double a = 6.283185307179586 * i / kSegments;
    world::Knot knot;
    knot.position = glm::vec3(radius * std::cos(a), 20 + 8 * std::sin(40 * a), radius * std::sin(a));
    knot.in_length = knot.out_length = 3.33f;
    world::set_tangent(knot, glm::vec3(-std::sin(a), 320 / radius * std::cos(40 * a), std::cos(a)));
    world::append_knot(document, knot);
  }
  world::set_closed(document, true);
  world::add_cart(document, document.track.segments.front(), 0);
  return document;
}

std::unique_ptr<app::Program> open_ring() {
  app::Options options;
  options.headless = true;
  auto program = app::make_program(options, {640, 360}, 0);
  if (!program.ok()) return nullptr;
  edit::Session& session = (*program)->session;
  session.document = ring();
  sim::derive(session.document, session.settings, session.clock, session.derived);
  sim::reset(session.document, session.derived, session.motion);
  session.settings.camera.target = session.document.entities.get<world::Knot>(session.document.track.knots[0]).position;
  for (int i = 0; i < 3; ++i) app::run_frame(**program, {platform::Tick{0}}, 0);
  return std::move(*program);
}

void frame(benchmark::State& state, bool drag) {
  auto program = open_ring();
  if (!program) return state.SkipWithError("no off-screen OpenGL");
  const world::Entity knot = program->session.document.track.knots[2500];
  const world::Name name = world::name_of(program->session.document, knot);
  const glm::vec3 at = world::knot(program->session.document, knot).position;
  if (drag) (void)app::apply(*program, edit::BeginGesture{});
  double outside = 0, frames = 0;
  for (auto _ : state) {
    double edit_ms = 0;
    if (drag) {
      const double before = program->surface->clock();
      (void)app::apply(*program, edit::MoveKnot{{name}, at + glm::vec3(0, static_cast<float>(std::sin(frames)), 0)});
      edit_ms = (program->surface->clock() - before) * 1e3;
    }
    app::run_frame(*program, {platform::Tick{1.0 / 60}}, 2);
    outside += program->stats.cpu_ms + edit_ms;
    ++frames;
  }
  state.counters["ms_outside_gl"] = outside / frames;
  state.counters["uploads"] = program->stats.uploads;
  state.counters["rebuilds"] = program->stats.rebuilds;
}

void memset_of(benchmark::State& state, std::size_t segments) {
  std::vector<unsigned char> bytes(segments * 65 * 24);
  int value = 1;
  for (auto _ : state) {
    std::memset(bytes.data(), value++ & 0xff, bytes.size());
    benchmark::ClobberMemory();
  }
}

BENCHMARK_CAPTURE(memset_of, all_polylines, kSegments)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(memset_of, two_polylines, 2)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(frame, still_5000, false)->Unit(benchmark::kMillisecond)->Iterations(10);
BENCHMARK_CAPTURE(frame, drag_5000, true)->Unit(benchmark::kMillisecond)->Iterations(10);

}  // namespace
}  // namespace coaster
