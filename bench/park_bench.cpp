// A park: pictures of samples beside the same pictures on the plain lawn, a wooden coaster beside a steel one, frames
// of a knot drag, what is written to OpenGL's buffers, building tiles of the land, and the memory of a land.
#include <benchmark/benchmark.h>

#include <malloc.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "app/scene.h"
#include "base/folders.h"
#include "bench_tracks.h"
#include "child.h"
#include "drawn.h"
#include "edit/commands/commands_document.h"
#include "edit/commands/commands_ride.h"
#include "edit/commands/commands_session.h"
#include "edit/session/findings.h"
#include "exchange/own/track_file.h"
#include "paired.h"
#include "sim/ground/land_mesh.h"
#include "sim/ground/plants.h"
#include "sim/solids/coaster_form.h"
#include "view/camera.h"
#include "world/appearance_settings.h"

namespace coaster::bench {
namespace park_bench {

constexpr platform::Size kLarge{1280, 720}, kSmall{640, 360};

world::Document sample(const char* name) {
  const auto text = base::Files().read(base::data_folder() / "tracks" / (std::string(name) + ".json"));
  return std::move(exchange::parse_track(*text, name)->document);
}

// Replaces the open document and looks at it: at the whole track, or as riders do three quarters of the lap on.
enum class Eye { whole, near, ride };
void look_at(app::Program& program, const world::Document& document, world::Scenery scenery, Eye eye) {
  edit::Session& session = program.session;
  session.document = document;
  ++session.edits;
  sim::derive(session.document, session.settings, session.measuring.clock, session.derived);
  sim::reset(session.document, session.derived, session.motion);
  session.settings.look->scenery = scenery;
  session.settings.camera_mode = eye == Eye::ride ? world::CameraMode::ride : world::CameraMode::orbit;
  session.settings.camera = view::frame_all({}, session.document, program.picture.free);
  if (eye == Eye::near) session.settings.camera.distance *= 0.15f;
  if (eye == Eye::ride) {
    (void)app::apply(program, edit::RideStart{});
    (void)app::apply(program, edit::RideSeek{0.75 * session.derived.length});
  }
  for (int i = 0; i < 3; ++i) app::run_frame(program, {platform::Tick{0}}, 0);
}

// Returns the ms that the pixels of a frame take without panels, the least of some frames.
double picture_ms(app::Program& program, platform::Size size, bool riding) {
  double least = 1e9;
  for (int i = 0; i < 7; ++i) {
    app::run_frame(program, {platform::Tick{1.0 / 60}}, riding ? 2 : 0);
    least = std::min(least, 1e3 * seconds([&] {
                              app::draw_scene_alone(program, size);
                              program.gl.Finish();
                            }));
  }
  return least;
}

// Compares pictures of a document with those of another, in turn, seen by the same eye.
struct Seen {
  world::Document document;
  world::Scenery scenery = world::Scenery::park;
};
void compare(benchmark::State& state, const Seen& seen, const Seen& other, const char* ratio, platform::Size size,
             Eye eye) {
  auto program = open_track(seen.document, size);
  if (!program) return state.SkipWithError("no off-screen OpenGL");
  std::vector<double> times, ratios;
  for (auto _ : state) {
    look_at(*program, other.document, other.scenery, eye);
    const double reference = picture_ms(*program, size, eye == Eye::ride);
    look_at(*program, seen.document, seen.scenery, eye);
    times.push_back(picture_ms(*program, size, eye == Eye::ride));
    ratios.push_back(times.back() / reference);
  }
  state.counters["ms_picture"] = median(times);
  state.counters[ratio] = median(ratios);
  state.counters["draw_calls"] = program->stats.draw_calls;
  state.counters["triangles"] = static_cast<double>(program->stats.triangles);
}

// With trees and water, beside the same track on the lawn as it was before parks.
void park_picture(benchmark::State& state, const char* name, platform::Size size, Eye eye) {
  world::Document lawn = sample(name);
  lawn.park = {};
  compare(state, {sample(name)}, {lawn, world::Scenery::plain}, "ratio_to_plain_lawn", size, eye);
}

void park_wooden(benchmark::State& state, Eye eye) {
  world::Document steel = sample("park_hollow_oak");
  steel.kind = world::CoasterKind::steel;
  compare(state, {sample("park_hollow_oak")}, {steel}, "ratio_to_steel", kLarge, eye);
}

// Moves some knots of the ring up and down a metre, as a hand does: the command and its frame outside OpenGL. Each knot
// counts with the least of its moves, since other programs may run beside this one.
struct Dragging {
  std::vector<double> ms;
  double patches = 0, kb = 0;  // uploaded for a frame, at most
};
Dragging dragging(app::Program& program) {
  const world::Document& document = program.session.document;
  Dragging found;
  for (std::size_t i = 5; i < document.track.knots.size(); i += 10) {
    const world::Entity knot = document.track.knots[i];
    const world::EntityName moved = world::name_of(document, knot);
    const glm::vec3 at = world::knot(document, knot).position;
    double least = 1e9;
    (void)app::apply(program, edit::BeginGesture{});
    for (int move = 1; move <= 6; ++move) {
      const double before = program.surface->clock();
      (void)app::apply(program,
                       edit::MoveKnot{{moved}, at + glm::vec3(0, std::sin(0.8f * static_cast<float>(move)), 0)});
      const double command_ms = 1e3 * (program.surface->clock() - before);
      app::run_frame(program, {platform::Tick{1.0 / 60}}, 0);
      const query::FrameStats& stats = program.stats;
      least = std::min(least, command_ms + stats.cpu_ms);
      found.patches = std::max<double>(found.patches, stats.park_uploads);
      found.kb = std::max(found.kb, static_cast<double>(stats.park_upload_bytes + stats.upload_bytes) / 1e3);
    }
    (void)app::apply(program, edit::EndGesture{});
    found.ms.push_back(least);
  }
  std::sort(found.ms.begin(), found.ms.end());
  return found;
}

void park_drag(benchmark::State& state) {
  const world::Document lawn = ring(200);
  world::Document hills = lawn;
  hills.park = world::usual_park(world::Land::hills, 7);
  auto program = open_track(lawn, kLarge);
  if (!program) return state.SkipWithError("no off-screen OpenGL");
  Dragging before, found;
  for (auto _ : state) {
    look_at(*program, lawn, world::Scenery::plain, Eye::whole);
    before = dragging(*program);
    look_at(*program, hills, world::Scenery::park, Eye::whole);
    found = dragging(*program);
  }
  state.counters["ms_drag"] = median(found.ms);
  state.counters["ms_drag_worst"] = found.ms.back();
  state.counters["ms_drag_on_lawn"] = median(before.ms);
  state.counters["uploads_of_patches"] = found.patches;
  state.counters["kb_uploaded"] = found.kb;
}

// The ground and its plants, built anew; each tile on one core.
void park_tiles(benchmark::State& state, const char* name) {
  const world::Document document = sample(name);
  sim::DerivedTrack derived;
  sim::derive(document, {}, {}, derived);
  const sim::TrackRoom room = sim::track_room(sim::form_of(document.kind));
  sim::Ground built;
  built.update(document, derived, room);
  const auto count = static_cast<double>(built.patches().size());
  paired(state, "tile", count,
         [&] {
           sim::Ground ground;
           ground.update(document, derived, room);
         },
         {});
  state.counters["ms_per_tile"] = state.counters["ns_per_tile"].value * 1e-6;
  std::vector<double> planting;
  for (int i = 0; i < 5; ++i) {
    const double before = cpu_seconds();
    sim::Plants().update(built);
    planting.push_back((cpu_seconds() - before) * 1e3 / count);
  }
  state.counters["ms_per_tile_of_plants"] = median(planting);
}

struct Opened {
  double mb = 0, kb_uploaded = 0, draw_calls = 0, triangles = 0;
};
Opened opened(const world::Document& document, world::Scenery scenery) {
  auto program = open_track(document, kLarge);
  if (!program) return {};
  program->session.settings.look->scenery = scenery;
  Opened figures;
  for (int i = 0; i < 3; ++i) {
    app::run_frame(*program, {platform::Tick{0}}, 0);
    figures.kb_uploaded += static_cast<double>(program->stats.park_upload_bytes) / 1e3;
  }
  app::draw_scene_alone(*program, kLarge);
  malloc_trim(0);
  figures.mb = resident_mb();  // with the code of a software OpenGL's shaders, and of what compiles them
  figures.draw_calls = program->stats.draw_calls;
  figures.triangles = static_cast<double>(program->stats.triangles);
  return figures;
}

// What a land's arrays take, in MB.
double land_arrays(const world::Document& document) {
  const auto allocated = [] {
    const struct mallinfo2 heap = mallinfo2();
    return static_cast<double>(heap.uordblks + heap.hblkhd) / 1e6;
  };
  sim::DerivedTrack derived;
  sim::derive(document, {}, {}, derived);
  const double before = allocated();
  sim::Ground ground;
  ground.update(document, derived, sim::track_room(sim::form_of(document.kind)));
  sim::Plants plants;
  plants.update(ground);
  sim::LandMesh mesh;
  mesh.update(ground, &plants, glm::normalize(glm::vec3(1, 2, 1)), true, {});
  return allocated() - before;
}

// What a land adds to a process that shows a track: one within the usual square, or moved out of it.
void park_memory(benchmark::State& state, float moved) {
  world::Document document = sample("park_hollow_oak"), lawn;
  for (const world::Entity knot : document.track.knots) document.entities.get<world::Knot>(knot).position.x += moved;
  lawn = document;
  lawn.park = {};
  Opened plain, park;
  for (auto _ : state)
    if (!in_child(plain, [&] { return opened(lawn, world::Scenery::plain); }) ||
        !in_child(park, [&] { return opened(document, world::Scenery::park); }))
      return state.SkipWithError("the measurement ended early");
  state.counters["mb_of_arrays_and_buffers"] = land_arrays(document) + park.kb_uploaded / 1e3;
  state.counters["mb_resident"] = park.mb - plain.mb;
  state.counters["kb_uploaded"] = park.kb_uploaded;
  state.counters["draw_calls"] = park.draw_calls;
  state.counters["triangles"] = park.triangles;
}

constexpr auto kMs = benchmark::kMillisecond;
BENCHMARK_CAPTURE(park_picture, oak_whole_720, "park_hollow_oak", kLarge, Eye::whole)->Unit(kMs)->Iterations(1);
BENCHMARK_CAPTURE(park_picture, oak_whole_360, "park_hollow_oak", kSmall, Eye::whole)->Unit(kMs)->Iterations(1);
BENCHMARK_CAPTURE(park_picture, oak_ride_720, "park_hollow_oak", kLarge, Eye::ride)->Unit(kMs)->Iterations(1);
BENCHMARK_CAPTURE(park_picture, oak_ride_360, "park_hollow_oak", kSmall, Eye::ride)->Unit(kMs)->Iterations(1);
BENCHMARK_CAPTURE(park_picture, fox_whole_720, "park_fox_and_thicket", kLarge, Eye::whole)->Unit(kMs)->Iterations(1);
BENCHMARK_CAPTURE(park_picture, fox_whole_360, "park_fox_and_thicket", kSmall, Eye::whole)->Unit(kMs)->Iterations(1);
BENCHMARK_CAPTURE(park_picture, fox_ride_720, "park_fox_and_thicket", kLarge, Eye::ride)->Unit(kMs)->Iterations(1);
BENCHMARK_CAPTURE(park_picture, fox_ride_360, "park_fox_and_thicket", kSmall, Eye::ride)->Unit(kMs)->Iterations(1);
BENCHMARK_CAPTURE(park_wooden, whole, Eye::whole)->Unit(kMs)->Iterations(1);
BENCHMARK_CAPTURE(park_wooden, near, Eye::near)->Unit(kMs)->Iterations(1);
BENCHMARK(park_drag)->Unit(kMs)->Iterations(1);
BENCHMARK_CAPTURE(park_tiles, oak, "park_hollow_oak")->UseManualTime()->Iterations(3);
BENCHMARK_CAPTURE(park_tiles, fox, "park_fox_and_thicket")->UseManualTime()->Iterations(3);
BENCHMARK_CAPTURE(park_memory, 768_m, 0.0f)->Unit(kMs)->Iterations(1);
BENCHMARK_CAPTURE(park_memory, 1536_m, 300.0f)->Unit(kMs)->Iterations(1);

}  // namespace park_bench
}  // namespace coaster::bench
