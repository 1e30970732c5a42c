// Other libraries for the same work: positions of 1000 cubics at 64 parameters each, by each library's usual calls.
// Each is compared with track_points(); ratio_to_peer: the library's time relative to it. Built for the installed
// libraries.
#include "bench_tracks.h"
#include "curve/kernels.h"
#include "paired.h"

#ifdef COASTER_PEER_EIGEN
#include <unsupported/Eigen/Splines>
#endif
#ifdef COASTER_PEER_2GEOM
#include <2geom/bezier-curve.h>
#endif
#ifdef COASTER_PEER_OCCT
#include <Geom_BezierCurve.hxx>
#include <TColgp_Array1OfPnt.hxx>
#endif
#ifdef COASTER_PEER_SISL
#include <sisl.h>
#endif
#ifdef COASTER_PEER_EMBREE
#include <embree3/rtcore.h>
#endif

namespace coaster::bench {
namespace peers_bench {

constexpr std::size_t kSegments = 1000;
constexpr int kSteps = 64;
constexpr int kOurRuns = 32;  // one takes microseconds, and the first runs with cold caches

// `evaluate(segment, t, out)` writes the position of one curve: three floats, or two for a 2-D library.
template <class Evaluate>
void beside_ours(benchmark::State& state, const Evaluate& evaluate) {
  const auto all = track_cubics(kSegments);
  std::vector<glm::vec3> ours(curve::track_vertices(kSegments, kSteps, curve::VertexLayout::chain)),
      theirs(kSegments * kSteps);
  const Work peer = [&] {
    for (std::size_t s = 0; s < kSegments; ++s)
      for (int i = 0; i < kSteps; ++i)
        evaluate(s, static_cast<double>(i) / kSteps, &theirs[s * kSteps + static_cast<std::size_t>(i)].x);
  };
  paired(state, "point", static_cast<double>(theirs.size()), peer,
         {{"ratio_to_peer", [&] {
             for (int i = 0; i < kOurRuns; ++i) curve::track_points(all, kSteps, curve::VertexLayout::chain, ours);
           }}});
  state.counters["ratio_to_peer"].value *= kOurRuns;
  double worst = 0;  // both results agree
  for (std::size_t i = 0; i < theirs.size(); ++i)
    worst = std::max(worst, static_cast<double>(glm::length(glm::vec2(theirs[i] - ours[i]))));
  state.counters["difference_m"] = worst;
  state.counters["checksum"] = checksum(theirs.data(), theirs.size());
}

#ifdef COASTER_PEER_EIGEN
void eigen_splines(benchmark::State& state) {
  using Spline = Eigen::Spline<double, 3, 3>;
  std::vector<Spline> splines;
  for (const auto& c : track_cubics(kSegments)) {
    Spline::KnotVectorType knots(8);
    knots << 0, 0, 0, 0, 1, 1, 1, 1;
    Spline::ControlPointVectorType controls(3, 4);
    const glm::vec3 p[] = {c.cubic.p0, c.cubic.p1, c.cubic.p2, c.cubic.p3};
    for (int i = 0; i < 4; ++i) controls.col(i) << p[i].x, p[i].y, p[i].z;
    splines.emplace_back(knots, controls);
  }
  beside_ours(state, [&](std::size_t s, double t, float* out) {
    const auto p = splines[s](t);
    for (int a = 0; a < 3; ++a) out[a] = static_cast<float>(p[a]);
  });
}
BENCHMARK(eigen_splines)->Name("peers/eigen_splines")->UseManualTime();
#endif

#ifdef COASTER_PEER_2GEOM
void lib2geom(benchmark::State& state) {
  std::vector<Geom::CubicBezier> curves;
  const auto at = [](glm::vec3 p) { return Geom::G2Unknowns(p.x, p.y); };
  for (const auto& c : track_cubics(kSegments))
    curves.emplace_back(at(c.cubic.p0), at(c.cubic.p1), at(c.cubic.p2), at(c.cubic.p3));
  beside_ours(state, [&](std::size_t s, double t, float* out) {
    const Geom::G2Unknowns p = curves[s].pointAt(t);
    out[0] = static_cast<float>(p[Geom::X]);
    out[1] = static_cast<float>(p[Geom::Y]);
  });
}
BENCHMARK(lib2geom)->Name("peers/lib2geom_in_the_plane")->UseManualTime();
#endif

#ifdef COASTER_PEER_OCCT
void opencascade(benchmark::State& state) {
  std::vector<Handle(Geom_BezierCurve)> curves;
  for (const auto& c : track_cubics(kSegments)) {
    TColgp_Array1OfPnt poles(1, 4);
    const glm::vec3 p[] = {c.cubic.p0, c.cubic.p1, c.cubic.p2, c.cubic.p3};
    for (int i = 0; i < 4; ++i) poles.SetValue(i + 1, gp_Pnt(p[i].x, p[i].y, p[i].z));
    curves.push_back(new Geom_BezierCurve(poles));
  }
  beside_ours(state, [&](std::size_t s, double t, float* out) {
    gp_Pnt p;
    curves[s]->D0(t, p);
    out[0] = static_cast<float>(p.X());
    out[1] = static_cast<float>(p.Y());
    out[2] = static_cast<float>(p.Z());
  });
}
BENCHMARK(opencascade)->Name("peers/opencascade")->UseManualTime();
#endif

#ifdef COASTER_PEER_SISL
void sisl(benchmark::State& state) {
  std::vector<SISLCurve*> curves;
  for (const auto& c : track_cubics(kSegments)) {
    double knots[] = {0, 0, 0, 0, 1, 1, 1, 1}, controls[12];
    const glm::vec3 p[] = {c.cubic.p0, c.cubic.p1, c.cubic.p2, c.cubic.p3};
    for (int i = 0; i < 12; ++i) controls[i] = p[i / 3][i % 3];
    curves.push_back(newCurve(4, 4, knots, controls, 1, 3, 1));
  }
  int left = 0;
  beside_ours(state, [&](std::size_t s, double t, float* out) {
    double p[3];
    int status = 0;
    s1227(curves[s], 0, t, &left, p, &status);
    for (int a = 0; a < 3; ++a) out[a] = static_cast<float>(p[a]);
  });
  for (SISLCurve* c : curves) freeCurve(c);
}
BENCHMARK(sisl)->Name("peers/sisl")->UseManualTime();
#endif

#ifdef COASTER_PEER_EMBREE
void embree(benchmark::State& state) {
  RTCDevice device = rtcNewDevice(nullptr);
  RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_FLAT_BEZIER_CURVE);
  const auto all = track_cubics(kSegments);
  auto* vertices = static_cast<float*>(
      rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT4, 16, 4 * all.size()));
  auto* index = static_cast<unsigned*>(
      rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT, 4, all.size()));
  for (std::size_t s = 0; s < all.size(); ++s) {
    const curve::Cubic& c = all[s].cubic;
    const glm::vec3 p[] = {c.p0, c.p1, c.p2, c.p3};
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t a = 0; a < 4; ++a) vertices[(4 * s + i) * 4 + a] = a < 3 ? p[i][static_cast<int>(a)] : 0.1f;
    index[s] = static_cast<unsigned>(4 * s);
  }
  rtcCommitGeometry(geometry);
  beside_ours(state, [&](std::size_t s, double t, float* out) {
    rtcInterpolate0(geometry, static_cast<unsigned>(s), static_cast<float>(t), 0, RTC_BUFFER_TYPE_VERTEX, 0, out, 3);
  });
  rtcReleaseGeometry(geometry);
  rtcReleaseDevice(device);
}
BENCHMARK(embree)->Name("peers/embree_interpolate")->UseManualTime();
#endif

}  // namespace peers_bench
}  // namespace coaster::bench
