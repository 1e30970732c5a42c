// The unit tangents of the vector kernels, and the table of all kernels. Included only by the files of each instruction
// set, after kernels_body.h.
#pragma once

#include "curve/kernels_body.h"

namespace {

// 2 / sqrt(q): the processor's estimate (relative error below 1.5 * 2^-12) and one Newton step, which squares the
// error: below 3e-7.
inline V8 twice_inverse_root(V8 q) {
  const V8 r = reciprocal_root(q);
  return r * (all(3) - (q * r) * r);
}

// One number for each of eight vertices, repeated for their three floats.
struct Spread {
  V8 of[3];
};
inline Spread spread(V8 r) {
#ifdef __AVX2__
  // Intrinsics, because gcc makes several shuffles of a general one that crosses halves.
  return {{_mm256_permutevar8x32_ps(r, _mm256_setr_epi32(0, 0, 0, 1, 1, 1, 2, 2)),
           _mm256_permutevar8x32_ps(r, _mm256_setr_epi32(2, 3, 3, 3, 4, 4, 4, 5)),
           _mm256_permutevar8x32_ps(r, _mm256_setr_epi32(5, 5, 6, 6, 6, 7, 7, 7))}};
#else
  const V4 a = r.low, b = r.high;
  return {{{__builtin_shufflevector(a, a, 0, 0, 0, 1), __builtin_shufflevector(a, a, 1, 1, 2, 2)},
           {__builtin_shufflevector(a, a, 2, 3, 3, 3), __builtin_shufflevector(b, b, 0, 0, 0, 1)},
           {__builtin_shufflevector(b, b, 1, 1, 2, 2), __builtin_shufflevector(b, b, 2, 3, 3, 3)}}};
#endif
}

// Differences of a parabola c0 + w (c1 + w c2) for step 1.
struct Parabola {
  V8 value, first, second;
};
inline Parabola start_parabola(V8 c0, V8 c1, V8 c2, V8 w) {
  return {c0 + w * (c1 + w * c2), c1 + (w + w + all(1)) * c2, c2 + c2};
}
inline void advance(Parabola& s) {
  s.value = s.value + s.first;
  s.first = s.first + s.second;
}

// Writes the derivative by w of `groups` groups of eight vertices, divided by its length; rows are counted in groups.
// Computes it twice, by vertices to measure (x, y, z apart) and packed to store, because that is cheaper than moving
// lanes. Returns four times the smallest squared speed.
inline V8 unit_run(const Rows& rows, int groups, float* out, V8 least) {
  alignas(16) float c1[4], c2[4], c3[4];  // twice the derivative, so that the root below gives 1 / its length
  store4(c1, rows.c[1] * 2);
  store4(c2, rows.c[2] * 4);
  store4(c3, rows.c[3] * 6);
  static const float kEighths[8] = {0, 0.125f, 0.25f, 0.375f, 0.5f, 0.625f, 0.75f, 0.875f};
  const V8 w = load(kEighths);
  Parabola x = start_parabola(all(c1[0]), all(c2[0]), all(c3[0]), w),
           y = start_parabola(all(c1[1]), all(c2[1]), all(c3[1]), w);
  Parabola z = start_parabola(all(c1[2]), all(c2[2]), all(c3[2]), w);
  const Pattern p = pattern(Rows{{rows.c[1], rows.c[2] * 2, rows.c[3] * 3, V4{}}});
  const Starts<3>& s = kStarts<3>;
  Parabola a = start_parabola(p.c[0][0], p.c[0][1], p.c[0][2], load(s.w)),
           b = start_parabola(p.c[1][0], p.c[1][1], p.c[1][2], load(s.w + 8));
  Parabola c = start_parabola(p.c[2][0], p.c[2][1], p.c[2][2], load(s.w + 16));
#pragma GCC unroll 2
  for (int g = 0; g < groups; ++g, out += 24) {
    const V8 q = x.value * x.value + y.value * y.value + z.value * z.value;
    least = at_most(q, least);
    const Spread r = spread(twice_inverse_root(at_least(q, all(1e-30f))));
    store(out, a.value * r.of[0]);
    store(out + 8, b.value * r.of[1]);
    store(out + 16, c.value * r.of[2]);
    advance(x), advance(y), advance(z);
    advance(a), advance(b), advance(c);
  }
  return least;
}

// True if a lane is below `low` or not a number.
inline bool any_below(V8 v, float low) {
#ifdef __AVX2__
  return _mm256_movemask_ps(_mm256_cmp_ps(v, all(low), _CMP_NGE_UQ)) != 0;
#else
  bool below = false;
  for (int i = 0; i < 4; ++i) below |= !(v.low[i] >= low) || !(v.high[i] >= low);
  return below;
#endif
}

// Marks in `slow` the curves that lose their tangent's direction to rounding, for the caller to compute exactly. The
// caller also writes the end of a polyline.
void track_unit_tangents(const Job& job) {
  constexpr int run = coaster::curve::detail::kRun;
  const float e = 8 / static_cast<float>(job.steps);
  const float* cubic = job.cubics;
  float* out = job.out;
  const int groups = job.steps / 8, rest = job.steps - groups * 8;
  for (std::size_t i = 0; i < job.count; ++i, cubic += 24, out += static_cast<std::ptrdiff_t>(job.points) * 3) {
    const Rows rows = rows_of(cubic, e);
    V8 least = all(1e30f);
    for (int from = 0; from < groups; from += run) {
      const Rows here = from == 0 ? rows : shifted(rows, static_cast<float>(from));
      least = unit_run(here, from + run <= groups ? run : groups - from, out + 24 * from, least);
    }
    if (rest != 0) {
      float few[24];
      least = unit_run(shifted(rows, static_cast<float>(groups)), 1, few, least);
      for (int k = 0; k < rest * 3; ++k) out[24 * groups + k] = few[k];
    }
    const V4 size = rows.c[1] * rows.c[1] + rows.c[2] * rows.c[2] * 4 + rows.c[3] * rows.c[3] * 9;
    constexpr float share = 4 * coaster::curve::detail::kSlow * coaster::curve::detail::kSlow;
    job.slow[i] = any_below(least, (size[0] + size[1] + size[2]) * share + 1e-29f);
  }
}

constexpr coaster::curve::detail::Kernels kKernels{positions_by_horner, positions_by_differences,
                                                   track_positions,     track_positions_streamed,
                                                   track_vertices,      track_unit_tangents};

}  // namespace
