// The line of sight through a pixel and the cone around it: where a point appears relative to the pixel, and which
// segments of a track may appear near it.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <limits>

#include "base/check.h"
#include "curve/cubic.h"
#include "sim/shape/segment_tree.h"
#include "view/camera.h"

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

namespace coaster::view {

// A point relative to a pixel, in homogeneous form: it appears (u/w, v/w) pixels from the pixel at depth w (1 in an
// orthographic view), and lies between the near and the far plane if |z| <= w. All four are affine in the point, so the
// values of a curve's control points are control values of the curve.
struct PixelRelative {
  double u = 0, v = 0, w = 0, z = 0;
};
inline constexpr double kNowhere = std::numeric_limits<double>::infinity();  // distance if nothing is hit
inline constexpr double kLeastDepth = 1e-4;  // m: smaller depths count as behind the eye
inline bool is_visible(const PixelRelative& s) { return s.w > kLeastDepth && s.z <= s.w && -s.z <= s.w; }

class PixelBeam {
 public:
  // `view` must be a perspective or an orthographic view. Any other has no eye, and nothing is seen.
  PixelBeam(const View& view, glm::dvec2 pixel);
  bool has_eye() const { return has_eye_; }

  // Metres by which depths of an orthographic view must differ for one to be in front; 0 for a perspective view.
  double same_depth() const { return same_depth_; }
  // Depth of a position on a curve, m: from the eye, or along an orthographic view.
  double depth(double w, glm::dvec3 place) const {
    return same_depth_ > 0 ? glm::dot(glm::dvec3(coarse_.w), place) : w;
  }

  PixelRelative operator()(glm::vec3 p) const {
    const auto row = [p](const glm::dvec4& r) { return r.x * p.x + r.y * p.y + r.z * p.z + r.w; };
    return {row(u_), row(v_), row(w_), row(z_)};
  }

  // The beam in float and relative to the eye, for tests of four boxes or chords at a time.
  struct Coarse {
    glm::vec3 eye{0};            // m, where u = v = w = 0
    glm::vec3 inverse{0};        // of the direction in which u = v = 0 and w grows by 1; never infinite
    glm::vec3 u{0}, v{0}, w{0};  // gradients, u and v divided by `pixels`
    float eye_depth = 0;         // w . eye
    double pixels = 1;           // pixels per metre across the line of sight at depth 1, at most
    double least_pixels = 1;     // the same in the direction where it is smallest
    float stretch = 1;           // largest |change of (u, v)| / pixels per metre
    float rounding = 0;          // m, error of coordinates and eye
  };
  const Coarse& coarse() const { return coarse_; }

 private:
  void set_coarse();
  void set_parallel(const View& view);
  glm::dvec4 u_{0}, v_{0}, w_{0}, z_{0};
  Coarse coarse_;
  double same_depth_ = 0;
  bool has_eye_ = false;
};

// --- Traversal of a segment tree: tests four boxes or four chords at a time in float, and never misses what double
// would find

// Four floats side by side: one register of every x86-64 processor and of most others. Picking gives the same result
// with each.
typedef float Float4 __attribute__((vector_size(16)));
typedef int Mask4 __attribute__((vector_size(16)));  // 0 (false) or -1 (true) per lane

inline Float4 all(float x) { return Float4{x, x, x, x}; }
inline std::array<float, 4> stored(Float4 x) { return std::bit_cast<std::array<float, 4>>(x); }
inline Float4 load(const std::array<float, 4>& x) { return std::bit_cast<Float4>(x); }

#if defined(__SSE2__)
inline Float4 min(Float4 a, Float4 b) { return _mm_min_ps(a, b); }
inline Float4 max(Float4 a, Float4 b) { return _mm_max_ps(a, b); }
inline unsigned mask_bits(Mask4 t) { return static_cast<unsigned>(_mm_movemask_ps(reinterpret_cast<__m128>(t))); }
#else
inline Float4 min(Float4 a, Float4 b) { return a < b ? a : b; }
inline Float4 max(Float4 a, Float4 b) { return a > b ? a : b; }
inline unsigned mask_bits(Mask4 t) { return (t[0] & 1u) | (t[1] & 2u) | (t[2] & 4u) | (t[3] & 8u); }
#endif

inline Float4 abs(Float4 x) { return max(x, -x); }

// Loops over the axes; unrolled at every optimisation level.
template <class Do>
[[gnu::always_inline]] inline void each_axis(Do what) {
  what(0), what(1), what(2);
}

// The beam's data for the box test, repeated four times.
struct BoxSweep {
  Float4 inverse[3], size[3], at_eye[3], depth[3], wider_at_eye;
  int near_side[3],
      far_side[3];  // which of a node's six rows the line of sight meets first and last, and the deepest per axis
  int deep_side[3];

  // `slope`: growth of the beam's radius in metres per metre of depth.
  BoxSweep(const PixelBeam::Coarse& beam, float slope) {
    for (int a = 0; a < 3; ++a) {
      inverse[a] = all(beam.inverse[a]), size[a] = all(std::abs(beam.inverse[a]));
      at_eye[a] = all(beam.eye[a] * beam.inverse[a]), depth[a] = all(beam.w[a] * slope);
      near_side[a] = beam.inverse[a] > 0 ? a : 3 + a, far_side[a] = beam.inverse[a] > 0 ? 3 + a : a;
      deep_side[a] = beam.w[a] > 0 ? 3 + a : a;
    }
    wider_at_eye = all(beam.rounding - beam.eye_depth * slope);
  }
};

// Bit i: box i of the node may contain a point within the limit, because the line of sight hits the box enlarged by the
// beam's radius at its far end.
[[gnu::always_inline]] inline unsigned boxes_met(const sim::TreeNode& node, const BoxSweep& beam) {
  const auto row = [&node](int i) { return load(node.bounds[static_cast<std::size_t>(i)]); };
  Float4 wider = beam.wider_at_eye, near_end = all(0), far_end = all(3e38f);
  each_axis([&](int a) { wider += beam.depth[a] * row(beam.deep_side[a]); });
  each_axis([&](int a) {
    const Float4 more = wider * beam.size[a];
    near_end = max(near_end, row(beam.near_side[a]) * beam.inverse[a] - beam.at_eye[a] - more);
    far_end = min(far_end, row(beam.far_side[a]) * beam.inverse[a] - beam.at_eye[a] + more);
  });
  return mask_bits(near_end <= far_end) & mask_bits(wider > all(0)) & node.lanes;
}

// The same for the segments of a block, by their chords as seen from the eye and their radii about these. `closeness`:
// for each lane, a value about proportional to the square of the distance on screen.
[[gnu::always_inline]] inline unsigned chords_met(const sim::SegmentBlock& block, const PixelBeam::Coarse& beam,
                                                  float slope, sim::FourFloats& closeness) {
  Float4 from_u = all(0), from_v = all(0), from_w = all(0), to_u = all(0), to_v = all(0), to_w = all(0);
  each_axis([&](int a) {
    const Float4 from = load(block.from[a]) - all(beam.eye[a]), to = load(block.to[a]) - all(beam.eye[a]);
    from_u += all(beam.u[a]) * from, from_v += all(beam.v[a]) * from, from_w += all(beam.w[a]) * from;
    to_u += all(beam.u[a]) * to, to_v += all(beam.v[a]) * to, to_w += all(beam.w[a]) * to;
  });
  const Float4 along_u = to_u - from_u, along_v = to_v - from_v, square = along_u * along_u + along_v * along_v;
  const Float4 share = min(max(-(from_u * along_u + from_v * along_v) / (square + all(1e-30f)), all(0)), all(1));
  const Float4 off_u = from_u + share * along_u, off_v = from_v + share * along_v, off = off_u * off_u + off_v * off_v;
  const Float4 depth = max(from_w, to_w), radius = load(block.radius);
  const Float4 rounding = all(2e-6f) * (abs(from_u) + abs(from_v) + abs(from_w) + abs(to_u) + abs(to_v) + abs(to_w)) +
                          all(beam.rounding * beam.stretch);
  const Float4 reach = all(slope) * (depth + radius) + radius * all(beam.stretch) + rounding;
  closeness = stored(off / (depth * depth + all(1e-30f)));
  return mask_bits(off <= reach * reach) & mask_bits(depth + radius + rounding > all(0)) & ((1u << block.count) - 1);
}

// Segments to be visited, the closest first.
class VisitQueue {
 public:
  static constexpr std::size_t kMost = 256;
  bool has_room_for_block() const { return count_ + 4 <= kMost; }
  bool empty() const { return count_ == 0; }
  void add(std::size_t index, float closeness) {
    items_[count_++] = {closeness, static_cast<std::uint32_t>(index)};
    std::push_heap(items_.begin(), items_.begin() + static_cast<std::ptrdiff_t>(count_), is_farther);
  }
  std::size_t next() {
    std::pop_heap(items_.begin(), items_.begin() + static_cast<std::ptrdiff_t>(count_), is_farther);
    return items_[--count_].index;
  }

 private:
  struct Item {
    float closeness;
    std::uint32_t index;
  };
  static bool is_farther(const Item& a, const Item& b) { return a.closeness > b.closeness; }
  std::array<Item, kMost> items_;
  std::size_t count_ = 0;
};

// Calls visit(i) for every segment i of the track that may come within limit() pixels of the beam's pixel, and for some
// others, roughly the closest first. A visit may lower the limit; segments that are only within the old limit may then
// be skipped. Returns the number of tree nodes visited.
template <class Limit, class Visit>
std::size_t visit_near(const sim::SegmentTree& tree, const PixelBeam& beam, Limit limit, Visit visit) {
  if (tree.nodes.empty() || !beam.has_eye()) return 0;
  const PixelBeam::Coarse& coarse = beam.coarse();
  // Metres of the reach at depth 1, including float rounding of short sums.
  const auto slope_of = [&] {
    return static_cast<float>(std::min(limit() / coarse.least_pixels, 1e6) * 1.000001 + 4e-6);
  };
  float slope = slope_of();
  BoxSweep sweep(coarse, slope);
  VisitQueue waiting;
  const auto look_at_waiting = [&] {
    while (!waiting.empty()) visit(waiting.next());
  };
  // Tests several nodes before their children are visited: the processor overlaps them, while a single test would wait
  // for its result.
  constexpr std::size_t kAtOnce = 4;
  std::array<std::int32_t, kAtOnce*(3 * sim::kMaxTreeDepth + 4)> nodes;
  std::array<std::int32_t, 4 * kAtOnce + 4> blocks;
  std::size_t node_count = 1, tested = 0;
  nodes[0] = 0;
  while (node_count > 0) {
    const std::size_t batch = std::min(node_count, kAtOnce);
    std::array<std::int32_t, kAtOnce> at;
    node_count -= batch;
    tested += batch;
    for (std::size_t i = 0; i < batch; ++i) at[i] = nodes[node_count + i];
    std::size_t block_count = 0;
    COASTER_CHECK(node_count + 4 * kAtOnce <= nodes.size(), "the tree is within its maximum depth");
    for (std::size_t i = 0; i < batch; ++i) {
      const sim::TreeNode& node = tree.nodes[static_cast<std::size_t>(at[i])];
      const unsigned met = boxes_met(node, sweep);
      for (unsigned left = met; left != 0; left &= left - 1) {
        const std::int32_t child = node.child[static_cast<std::size_t>(std::countr_zero(left))];
        if (child >= 0) {
          nodes[node_count++] = child;
          __builtin_prefetch(&tree.nodes[static_cast<std::size_t>(child)]);
        } else {
          blocks[block_count++] = ~child;
          __builtin_prefetch(&tree.blocks[static_cast<std::size_t>(~child)]);
        }
      }
    }
    for (std::size_t i = 0; i < block_count; ++i) {
      const sim::SegmentBlock& block = tree.blocks[static_cast<std::size_t>(blocks[i])];
      sim::FourFloats closeness;
      unsigned met = chords_met(block, coarse, slope, closeness);
      if (!waiting.has_room_for_block()) {
        look_at_waiting();
        slope = slope_of();
        sweep = BoxSweep(coarse, slope);
      }
      for (; met != 0; met &= met - 1) {
        const auto lane = static_cast<std::size_t>(std::countr_zero(met));
        waiting.add(static_cast<std::size_t>(block.first) + lane, closeness[lane]);
      }
    }
  }
  look_at_waiting();
  return tested;
}

// --- One cubic as seen from a pixel: all positions with a local minimum of the distance

// A local minimum of the distance on screen from the pixel, or an end of the visible part.
struct SightedPlace {
  double t = 0;
  double square = 0;  // px^2, squared distance
  double depth = 0;   // m, depth from the eye
};
inline constexpr int kMaxSightedPlaces = 24;
struct SightedPlaces {
  std::array<SightedPlace, kMaxSightedPlaces> items;
  int count = 0;
  const SightedPlace* begin() const { return items.data(); }
  const SightedPlace* end() const { return items.data() + count; }
};

using SightedControls = std::array<PixelRelative, 4>;
SightedControls sighted(const curve::Cubic& cubic, const PixelBeam& beam);

// Returns false if all of the curve in front of the eye is certainly more than `limit` pixels (finite) away.
bool may_come_near(const SightedControls& controls, double limit);

// Returns the positions in the order of t, each t to 1e-9 or, at a stationary inflection, to rounding. The derivative
// of the squared distance has the sign of N = (U U' + V V') W - (U^2 + V^2) W', of degree 8. Its Bernstein coefficients
// bound the number of its roots (Descartes' rule), so none is missed, however sharply the curve turns on screen.
// Invisible parts (behind the eye, beyond the planes) do not count.
SightedPlaces nearest_places(const SightedControls& controls);

// Returns the sign of the squared distance's derivative towards greater t at an end, 0 or 1, of a curve that is visible
// there.
int slope_at_end(const SightedControls& controls, int end);

}  // namespace coaster::view
