// Frames of 5,000 and 100,000 segments at 64 steps, drawn off screen: processor time outside OpenGL (panels, commands,
// derived data, the cache), for a still frame and for a frame of a knot drag; and of 1,000 segments at 1280x720 while a
// train runs. Opening a file, to the end of the first picture. For comparison, a memset of the bytes of all polylines
// and of those that a drag uploads, so that the ratio is comparable between machines.
#include <benchmark/benchmark.h>

#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <utility>
#include <vector>

#include "bench_tracks.h"
#include "child.h"
#include "drawn.h"
#include "edit/commands/commands_document.h"
#include "edit/commands/commands_ride.h"
#include "edit/commands/commands_session.h"
#include "exchange/own/track_file.h"

namespace coaster {
namespace frame_bench {

using bench::open_track, bench::ring;

constexpr int kSegments = 5000, kRiddenSegments = 1000, kManySegments = 100'000;

// Returns the ms to set `bytes`, averaged over enough repetitions.
double memset_ms(const platform::Surface& clock, std::vector<unsigned char>& bytes) {
  const int times = static_cast<int>(1 + (std::size_t{1} << 24) / bytes.size());
  const double before = clock.clock();
  for (int i = 0; i < times; ++i) {
    std::memset(bytes.data(), i & 0xff, bytes.size());
    benchmark::ClobberMemory();
  }
  return (clock.clock() - before) * 1e3 / times;
}

void frame(benchmark::State& state, int segments, bool drag) {
  auto program = open_track(segments == kSegments ? ring(segments) : bench::circuit(segments), {640, 360});
  if (!program) return state.SkipWithError("no off-screen OpenGL");
  const world::Entity knot = program->session.document.track.knots[2500];
  const world::EntityName name = world::name_of(program->session.document, knot);
  const glm::vec3 at = world::knot(program->session.document, knot).position;
  if (drag) (void)app::apply(*program, edit::BeginGesture{});
  std::vector<unsigned char> bytes(static_cast<std::size_t>(drag ? 2 : segments) * 65 * sizeof(float) * 6);
  double outside = 0, frames = 0, set = 0;
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
    set += memset_ms(*program->surface, bytes);
  }
  state.counters["ms_outside_gl"] = outside / frames;
  state.counters["ratio_to_memset"] = outside / set;  // of all polylines, or of the two that a drag uploads
  state.counters["uploads"] = program->stats.uploads;
  state.counters["rebuilds"] = program->stats.rebuilds;
}

// With panels and a running train, in the default view.
void ride_1000(benchmark::State& state) {
  auto program = open_track(ring(kRiddenSegments), {1280, 720});
  if (!program) return state.SkipWithError("no off-screen OpenGL");
  (void)app::apply(*program, edit::RideStart{});
  app::run_frame(*program, {platform::Tick{1.0 / 60}}, 2);
  double outside = 0, gl = 0, frames = 0, uploads = 0, shadow_maps = 0;
  for (auto _ : state) {
    app::run_frame(*program, {platform::Tick{1.0 / 60}}, 2);
    outside += program->stats.cpu_ms;
    gl += program->stats.gl_ms;
    uploads += program->stats.uploads;
    shadow_maps += program->stats.shadow_maps;
    ++frames;
  }
  state.counters["ms_outside_gl"] = outside / frames;
  state.counters["ms_gl"] = gl / frames;
  state.counters["uploads"] = uploads;
  state.counters["shadow_maps"] = shadow_maps / frames;
  state.counters["draw_calls"] = program->stats.draw_calls;
  state.counters["triangles"] = static_cast<double>(program->stats.triangles);
}

// 10,000 trains of one energy on a ring of 50 km, moved by the timetable, all of them in the picture. Their start is
// that of the first, and they are spread by seek.
struct Riding {
  double ms_outside_gl = 0, ms_tick = 0, ms_gl = 0, mb_resident = 0, triangles = 0, draw_calls = 0;
};
Riding ride_of_many() {
  constexpr std::size_t kTrains = 10'000;
  constexpr int kFrames = 60, kTicks = 2;
  world::Document document = ring(kSegments);
  document.start_speed = 60;  // the lap must fit into a timetable
  while (document.entities.pool<world::Train>().size() < kTrains)
    world::add_cart(document, document.track.segments.front(), 0);
  auto program = open_track(std::move(document), {1280, 720});
  if (!program) return {};
  edit::Session& session = program->session;
  session.settings.integrator = base::value_named<world::IntegratorId>("precomputed").value();
  (void)app::apply(*program, edit::RideStart{});
  for (std::size_t i = 0; i < kTrains; ++i)
    sim::seek(session.document, session.derived, session.motion.carts.entities()[i],
              session.derived.length * static_cast<double>(i) / static_cast<double>(kTrains), session.motion);
  session.settings.camera.target = {0, 0, 0}, session.settings.camera.distance = 12'000;
  for (int i = 0; i < 3; ++i) app::run_frame(*program, {platform::Tick{1.0 / 60}}, kTicks);
  Riding riding;
  for (int i = 0; i < kFrames; ++i) {
    app::run_frame(*program, {platform::Tick{1.0 / 60}}, kTicks);
    riding.ms_outside_gl += program->stats.cpu_ms / kFrames, riding.ms_gl += program->stats.gl_ms / kFrames;
  }
  riding.ms_tick = session.measuring.ride_cost.ns_per_tick * 1e-6;
  riding.mb_resident = bench::resident_mb();
  riding.triangles = static_cast<double>(program->stats.triangles), riding.draw_calls = program->stats.draw_calls;
  return riding;
}

void ride_10000_trains(benchmark::State& state) {
  Riding riding;
  for (auto _ : state)
    if (!bench::in_child(riding, ride_of_many) || riding.triangles == 0)
      return state.SkipWithError("no off-screen OpenGL");
  state.counters["ms_outside_gl"] = riding.ms_outside_gl;
  state.counters["ms_tick"] = riding.ms_tick;
  state.counters["ms_gl"] = riding.ms_gl;
  state.counters["mb_resident"] = riding.mb_resident;
  state.counters["triangles"] = riding.triangles;
  state.counters["draw_calls"] = riding.draw_calls;
}

struct Opening {
  double cpu_s = 0, resident_mb = 0, most_mb = 0, triangles = 0, polyline_mb = 0, upload_mb = 0;
};
Opening opening_of(const std::string& path) {
  app::Options options;
  options.headless = true;
  const double before = bench::cpu_seconds();
  auto program = app::make_program(options, {640, 360}, 0);
  if (!program.ok() || !app::apply(**program, edit::LoadTrack{path})) return {};
  app::run_frame(**program, {platform::Tick{0}}, 0);
  const query::FrameStats& stats = (*program)->stats;
  return {bench::cpu_seconds() - before,
          bench::resident_mb(),
          bench::most_resident_mb(),
          static_cast<double>(stats.triangles),
          static_cast<double>(stats.polyline_bytes) / 1e6,
          static_cast<double>(stats.upload_bytes) / 1e6};
}

// Opens a file and draws one picture, without its pixels.
void open_file(benchmark::State& state) {
  const std::filesystem::path path = std::filesystem::temp_directory_path() / "coaster_open_bench.json";
  std::ofstream(path) << exchange::print_track(bench::circuit(static_cast<int>(state.range(0))));
  Opening opening;
  for (auto _ : state)
    if (!bench::in_child(opening, [&] { return opening_of(path.string()); }) || opening.cpu_s == 0)
      return state.SkipWithError("not opened");
  std::filesystem::remove(path);
  state.counters["cpu_s_open"] = opening.cpu_s;
  state.counters["mb_resident"] = opening.resident_mb;
  state.counters["mb_most"] = opening.most_mb;
  state.counters["mb_polylines"] = opening.polyline_mb;
  state.counters["mb_uploaded"] = opening.upload_mb;
  state.counters["triangles"] = opening.triangles;
}

BENCHMARK(open_file)->Arg(5000)->Arg(20000)->Arg(100000)->Unit(benchmark::kMillisecond)->Iterations(1);
BENCHMARK(ride_10000_trains)->Unit(benchmark::kMillisecond)->Iterations(1);
BENCHMARK(ride_1000)->Unit(benchmark::kMillisecond)->Iterations(20);
BENCHMARK_CAPTURE(frame, still_5000, kSegments, false)->Unit(benchmark::kMillisecond)->Iterations(100);
BENCHMARK_CAPTURE(frame, drag_5000, kSegments, true)->Unit(benchmark::kMillisecond)->Iterations(100);
BENCHMARK_CAPTURE(frame, still_100000, kManySegments, false)->Unit(benchmark::kMillisecond)->Iterations(100);
BENCHMARK_CAPTURE(frame, drag_100000, kManySegments, true)->Unit(benchmark::kMillisecond)->Iterations(100);

}  // namespace frame_bench
}  // namespace coaster
