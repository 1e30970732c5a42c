// Picking on tracks of 1,000 to 100,000 segments that cross themselves all over the screen: by the hierarchy, by
// testing every segment, and compared with Embree's flat curves; and the cost of a drag for the hierarchy. Views from
// 60 to 140 m, 1280x720; half the pixels are aimed at the track (with a reach of 8 px, among everything along the line
// of sight), half are anywhere in the picture.
#include <cmath>
#include <random>

#include "paired.h"
#include "sim/shape/derived_track.h"
#include "view/pick.h"
#include "world/evaluation_settings.h"
#include "world/topology.h"

#ifdef COASTER_PEER_EMBREE
#include <embree3/rtcore.h>
#endif

namespace coaster::bench {
namespace pick_bench {

constexpr view::Viewport kViewport{0, 0, 1280, 720};
constexpr float kReach = 8;      // px
constexpr float kThick = 0.92f;  // m, the reach at 100 m
constexpr std::size_t kPicks = 512;

// Returns a Lissajous figure of segments of about ten metres over a square, strands about ten metres apart, hills of 60
// m.
sim::DerivedTrack tangle(int segments) {
  const double half = 5 * std::sqrt(static_cast<double>(segments)),
               turns = std::floor(segments * 10 / (5.6 * half * 1.4));
  const auto at = [&](double a) {
    return glm::dvec3(half * std::sin(turns * a), 35 + 30 * std::sin(7.3 * turns * a + 0.4),
                      half * std::sin((turns + 1) * a + 1.1));
  };
  world::Document document;
  const double step = 6.283185307179586 / segments;
  for (int i = 0; i < segments; ++i) {
    const glm::dvec3 slope = (at(step * i + 1e-6) - at(step * i - 1e-6)) / 2e-6;
    world::Knot knot;
    knot.position = glm::vec3(at(step * i));
    knot.in_length = knot.out_length = std::max(static_cast<float>(glm::length(slope) * step / 3), world::kMinHandle);
    world::set_tangent(knot, glm::vec3(slope));
    world::append_knot(document, knot);
  }
  world::set_closed(document, true);
  world::Settings settings;
  settings.evaluation->steps = 1;
  sim::DerivedTrack derived;
  sim::derive(document, settings, {}, derived);
  return derived;
}

struct Aim {
  view::View view;
  glm::vec2 pixel;
};

std::vector<Aim> aims(const sim::DerivedTrack& derived) {
  std::mt19937 bits(11);
  const auto uniform = [&](double low, double high) { return low + (high - low) * (bits() / 4294967296.0); };
  std::vector<Aim> all;
  while (all.size() < kPicks) {
    const curve::Cubic& cubic = derived.tree.cubics[bits() % derived.tree.cubics.size()];
    const glm::vec3 place(curve::point(cubic, uniform(0, 1)));
    const glm::vec3 target = place + glm::vec3(uniform(-20, 20), uniform(-5, 5), uniform(-20, 20));
    const world::Camera camera{target, static_cast<float>(uniform(-180, 180)), static_cast<float>(uniform(5, 60)),
                               static_cast<float>(uniform(60, 140))};
    const view::View view = view::orbit_view(camera, kViewport);
    const auto seen = view::project(view, place);
    if (!seen || !kViewport.contains(glm::vec2(*seen))) continue;
    all.push_back({view, all.size() % 2 == 0 ? glm::vec2(*seen) : glm::vec2(uniform(0, 1280), uniform(0, 720))});
  }
  return all;
}

// Picks are timed one after the other, as in frames; testing all segments evicts the caches, so an untimed round comes
// first.
void pick(benchmark::State& state) {
  const sim::DerivedTrack derived = tangle(static_cast<int>(state.range(0)));
  const std::vector<Aim> all = aims(derived);
  constexpr std::size_t kOfAll = 4;  // picks among all segments per iteration
  double sum = 0;
  std::size_t found = 0, next = 0;
  std::vector<double> times, ratios;
  const Work picks = [&] {
    sum = 0, found = 0;
    for (const Aim& aim : all)
      if (const auto place = view::pick_curve(derived, aim.view, aim.pixel, kReach)) sum += place->t, ++found;
  };
  for (auto _ : state) {
    picks();
    const double time = seconds(picks) / static_cast<double>(all.size());
    const double of_all = seconds([&] {
      for (std::size_t i = 0; i < kOfAll; ++i, next = (next + 1) % all.size())
        benchmark::DoNotOptimize(view::pick_curve_of_all(derived, all[next].view, all[next].pixel, kReach));
    });
    state.SetIterationTime(time * static_cast<double>(all.size()));
    times.push_back(time), ratios.push_back(of_all / kOfAll / time);
  }
  state.counters["ns_per_pick"] = median(times) * 1e9;
  state.counters["ratio_of_all"] = median(ratios);
  state.counters["ratio_found"] = static_cast<double>(found) / static_cast<double>(all.size());
  state.counters["checksum"] = sum;
}
BENCHMARK(pick)->Name("pick/hierarchy")->Arg(1000)->Arg(10000)->Arg(100000)->UseManualTime();

// Drags one knot: refits its two segments' boxes and those above them; the reference rebuilds the tree.
void refit(benchmark::State& state) {
  sim::DerivedTrack derived = tangle(static_cast<int>(state.range(0)));
  sim::SegmentTree again;
  const std::size_t middle = derived.tree.cubics.size() / 2;
  constexpr int kMoves = 64;
  float height = 0;
  paired(state, "drag", kMoves,
         [&] {
           for (int i = 0; i < kMoves; ++i) {
             height = height > 3 ? -3 : height + 0.37f;
             curve::Cubic &before = derived.tree.cubics[middle - 1], &after = derived.tree.cubics[middle];
             before.p2.y += height, before.p3.y += height, after.p0.y += height, after.p1.y += height;
             sim::refit_tree(std::array{middle - 1, middle}, derived.tree);
           }
         },
         {{"ratio_to_building", [&] { sim::build_tree(derived.tree.cubics, again); }}});
  state.counters["ratio_to_building"].value /= kMoves;
  state.counters["checksum"] = derived.tree.nodes[0].bounds[4][0];
}
BENCHMARK(refit)->Name("pick/refit_a_drag")->Arg(1000)->Arg(10000)->Arg(100000)->UseManualTime();

#ifdef COASTER_PEER_EMBREE
struct EmbreeScene {
  RTCDevice device = rtcNewDevice(nullptr);
  RTCScene scene = rtcNewScene(device);
  EmbreeScene(const std::vector<curve::Cubic>& cubics, float radius) {
    RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_FLAT_BEZIER_CURVE);
    auto* vertices = static_cast<glm::vec4*>(rtcSetNewGeometryBuffer(
        geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT4, sizeof(glm::vec4), 4 * cubics.size()));
    auto* index = static_cast<unsigned*>(
        rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT, 4, cubics.size()));
    for (std::size_t s = 0; s < cubics.size(); ++s) {
      const glm::vec3 p[] = {cubics[s].p0, cubics[s].p1, cubics[s].p2, cubics[s].p3};
      for (std::size_t i = 0; i < 4; ++i) vertices[4 * s + i] = glm::vec4(p[i], radius);
      index[s] = static_cast<unsigned>(4 * s);
    }
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene, geometry);
    rtcReleaseGeometry(geometry);
    rtcCommitScene(scene);
  }
  EmbreeScene(const EmbreeScene&) = delete;
  ~EmbreeScene() {
    rtcReleaseScene(scene);
    rtcReleaseDevice(device);
  }
};

RTCRayHit ray_of(const view::Ray& ray) {
  RTCRayHit out{};
  out.ray.org_x = ray.origin.x, out.ray.org_y = ray.origin.y, out.ray.org_z = ray.origin.z;
  out.ray.dir_x = ray.direction.x, out.ray.dir_y = ray.direction.y, out.ray.dir_z = ray.direction.z;
  out.ray.tnear = 0.2f, out.ray.tfar = 20000;
  out.ray.mask = 0xffffffffu;
  out.hit.geomID = out.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
  return out;
}

// Alternates the program's picks with Embree's first hit of the same rays: program's time / Embree's. Embree's curves
// have a constant thickness.
void pick_beside_embree(benchmark::State& state) {
  const sim::DerivedTrack derived = tangle(static_cast<int>(state.range(0)));
  const std::vector<Aim> all = aims(derived);
  EmbreeScene embree(derived.tree.cubics, kThick);
  std::size_t hits = 0, found = 0;
  std::vector<RTCRayHit> rays;
  for (const Aim& aim : all) rays.push_back(ray_of(view::ray_through(aim.view, aim.pixel)));
  paired(state, "pick", static_cast<double>(all.size()),
         [&] {
           found = 0;
           for (const Aim& aim : all) found += view::pick_curve(derived, aim.view, aim.pixel, kReach).has_value();
         },
         {{"ratio_to_embree", [&] {
             hits = 0;
             for (const RTCRayHit& ray : rays) {
               RTCIntersectContext context;
               rtcInitIntersectContext(&context);
               RTCRayHit hit = ray;
               rtcIntersect1(embree.scene, &context, &hit);
               hits += hit.hit.geomID != RTC_INVALID_GEOMETRY_ID;
             }
           }}});
  state.counters["ratio_found"] = static_cast<double>(found) / static_cast<double>(all.size());
  state.counters["ratio_embree_hit"] = static_cast<double>(hits) / static_cast<double>(all.size());
}
BENCHMARK(pick_beside_embree)->Name("pick/beside_embree")->Arg(1000)->Arg(10000)->Arg(100000)->UseManualTime();
#endif

}  // namespace pick_bench
}  // namespace coaster::bench
