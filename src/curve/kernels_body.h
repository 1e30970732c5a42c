// The bodies of the vector kernels, compiled once per instruction set (kernels_avx2.cpp, kernels_baseline.cpp);
// included by no other files. Everything is in an anonymous namespace and no library header is used, so the linker
// cannot mix code for different processors.
//
// A vertex is three floats, each its own cubic in u = 0, 1, .. n, t = u/n, with coefficients scaled by powers of 1/n.
// A group is 24 floats: three vectors of eight, which hold 8 vertices. Coefficients are in the order of the vertices'
// floats, so results are stored without a shuffle.
#pragma once

#if defined(__SSE2__)
#include <immintrin.h>
#endif

#include <cstddef>

#include "curve/kernels_jobs.h"

namespace {

using coaster::curve::detail::KernelJob;

// Eight floats side by side: one AVX register, or two of the baseline's.
typedef float V4 __attribute__((vector_size(16)));

#ifdef __AVX2__
typedef float V8 __attribute__((vector_size(32)));
typedef float LooseV8 __attribute__((vector_size(32), aligned(4), may_alias));
inline V8 all(float x) { return V8{x, x, x, x, x, x, x, x}; }
inline V8 load(const float* p) { return *reinterpret_cast<const LooseV8*>(p); }
inline void store(float* p, V8 v) { *reinterpret_cast<LooseV8*>(p) = v; }
inline void stream(float* p, V8 v) { _mm256_stream_ps(p, v); }
inline V8 join(V4 low, V4 high) { return __builtin_shufflevector(low, high, 0, 1, 2, 3, 4, 5, 6, 7); }
#else
// Two halves by hand: compilers keep a 32-byte vector in memory if the processor lacks it.
struct V8 {
  V4 low, high;
  friend V8 operator+(V8 a, V8 b) { return {a.low + b.low, a.high + b.high}; }
  friend V8 operator*(V8 a, V8 b) { return {a.low * b.low, a.high * b.high}; }
};
typedef float LooseV4 __attribute__((vector_size(16), aligned(4), may_alias));
inline V8 all(float x) { return {V4{x, x, x, x}, V4{x, x, x, x}}; }
inline V8 load(const float* p) {
  return {*reinterpret_cast<const LooseV4*>(p), *reinterpret_cast<const LooseV4*>(p + 4)};
}
inline void store(float* p, V8 v) {
  *reinterpret_cast<LooseV4*>(p) = v.low;
  *reinterpret_cast<LooseV4*>(p + 4) = v.high;
}
inline V8 join(V4 low, V4 high) { return {low, high}; }
#if defined(__SSE2__)
inline void stream(float* p, V8 v) {
  _mm_stream_ps(p, v.low);
  _mm_stream_ps(p + 4, v.high);
}
#else
inline void stream(float* p, V8 v) { store(p, v); }
#endif
#endif

inline V4 load4(const float* p) {
  typedef float Loose __attribute__((vector_size(16), aligned(4), may_alias));
  return *reinterpret_cast<const Loose*>(p);
}

constexpr int kGroup = 8;  // vertices

// The coefficients of one cubic, lanes x y z (the fourth lane is arbitrary).
struct CubicCoefficients {
  V4 c[4];
};
// Coefficients start at float 12 of a PreparedCubic; c3 is loaded one float early, so that nothing past the end is
// read.
inline CubicCoefficients coefficients_of(const float* cubic, float e) {
  const V4 c3 = load4(cubic + 20);
  return {{load4(cubic + 12), load4(cubic + 15) * e, load4(cubic + 18) * (e * e),
           __builtin_shufflevector(c3, c3, 1, 2, 3, 3) * (e * e * e)}};
}
// Returns the same cubic with its parameter counted from w.
inline CubicCoefficients shifted(const CubicCoefficients& r, float w) {
  const V4 a = r.c[2] + r.c[3] * w, b = a + r.c[3] * w, d = r.c[1] + a * w;
  return {{r.c[0] + d * w, d + b * w, b + r.c[3] * w, r.c[3]}};
}

// c[k][i]: coefficient i in the lanes of vector k of a group.
struct GroupCoefficients {
  V8 c[3][4];
};
inline GroupCoefficients pattern(const CubicCoefficients& rows) {
  GroupCoefficients p;
  for (int i = 0; i < 4; ++i) {
    const V4 v = rows.c[i];
#ifdef __AVX2__
    const V8 w = join(v, v);
    p.c[0][i] = _mm256_permutevar_ps(w, _mm256_setr_epi32(0, 1, 2, 0, 1, 2, 0, 1));
    p.c[1][i] = _mm256_permutevar_ps(w, _mm256_setr_epi32(2, 0, 1, 2, 0, 1, 2, 0));
    p.c[2][i] = _mm256_permutevar_ps(w, _mm256_setr_epi32(1, 2, 0, 1, 2, 0, 1, 2));
#else
    const V4 xyzx = __builtin_shufflevector(v, v, 0, 1, 2, 0), yzxy = __builtin_shufflevector(v, v, 1, 2, 0, 1);
    const V4 zxyz = __builtin_shufflevector(v, v, 2, 0, 1, 2);
    p.c[0][i] = join(xyzx, yzxy);
    p.c[1][i] = join(zxyz, xyzx);
    p.c[2][i] = join(yzxy, zxyz);
#endif
  }
  return p;
}

// The vertex number of each float of a group.
inline V8 vertex_numbers(int k) {
  static const float numbers[24] = {0, 0, 0, 1, 1, 1, 2, 2, 2, 3, 3, 3, 4, 4, 4, 5, 5, 5, 6, 6, 6, 7, 7, 7};
  return load(numbers + 8 * k);
}

inline V8 horner(const V8* c, V8 w) { return c[0] + w * (c[1] + w * (c[2] + w * c[3])); }

// Differences of a cubic in w, one group long, for step 1: value, first, second, third. The polynomials in w are
// constants.
struct DifferenceStarts {
  alignas(32) float w[24], first2[24], first3[24], second3[24];
  constexpr DifferenceStarts() : w(), first2(), first3(), second3() {
    for (int i = 0; i < 24; ++i) {
      const int vertex = i / 3;
      const float x = static_cast<float>(vertex) * 0.125f;
      w[i] = x;
      first2[i] = 2 * x + 1;
      first3[i] = 3 * x * x + 3 * x + 1;
      second3[i] = 6 * x + 6;
    }
  }
};
inline constexpr DifferenceStarts kStarts{};

struct DifferenceState {
  V8 value, first, second, third;
};
inline DifferenceState start(const V8* c, int k) {
  const DifferenceStarts& s = kStarts;
  return {horner(c, load(s.w + 8 * k)), c[1] + load(s.first2 + 8 * k) * c[2] + load(s.first3 + 8 * k) * c[3],
          c[2] + c[2] + load(s.second3 + 8 * k) * c[3], all(6) * c[3]};
}
inline void advance(DifferenceState& s) {
  s.value = s.value + s.first;
  s.first = s.first + s.second;
  s.second = s.second + s.third;
}

template <bool S>
inline void put(float* p, V8 v) {
  if constexpr (S) stream(p, v);
  else store(p, v);
}

// Writes groups by Horner's rule, starting at vertex `first`.
template <bool S>
inline void horner_groups(const GroupCoefficients& p, int first, int groups, float* out) {
  V8 u[3];
  for (int k = 0; k < 3; ++k) u[k] = vertex_numbers(k) + all(static_cast<float>(first));
  for (int g = 0; g < groups; ++g, out += 24)
    for (int k = 0; k < 3; ++k) {
      put<S>(out + 8 * k, horner(p.c[k], u[k]));
      u[k] = u[k] + all(static_cast<float>(kGroup));
    }
}

// Writes `groups` groups by differences; each lane steps one whole group. Careful: values are relative to the run's
// first point, which is added when storing, so each value rounds only once at the size of the coordinates, for one more
// addition.
template <bool S, bool Careful>
inline void difference_run(GroupCoefficients p, int groups, float* out) {
  const V8 base0 = p.c[0][0], base1 = p.c[1][0], base2 = p.c[2][0];
  if constexpr (Careful)
    for (int k = 0; k < 3; ++k) p.c[k][0] = all(0);
  DifferenceState a = start(p.c[0], 0), b = start(p.c[1], 1), c = start(p.c[2], 2);
#pragma GCC unroll 8
  for (int g = 0; g < groups; ++g) {
    put<S>(out + 24 * g, Careful ? a.value + base0 : a.value);
    advance(a);
    put<S>(out + 24 * g + 8, Careful ? b.value + base1 : b.value);
    advance(b);
    put<S>(out + 24 * g + 16, Careful ? c.value + base2 : c.value);
    advance(c);
  }
}

// Writes all groups, restarting every kRun groups from the cubic shifted there. Whole runs have a fixed length.
template <bool S, bool Careful>
inline void difference_groups(const CubicCoefficients& rows, int groups, float* out) {
  constexpr int run = coaster::curve::detail::kRun;
  if (groups >= run) difference_run<S, Careful>(pattern(rows), run, out);
  int from = groups >= run ? run : 0;
  for (; from + run <= groups; from += run)
    difference_run<S, Careful>(pattern(shifted(rows, static_cast<float>(from))), run, out + 24 * from);
  if (from < groups)
    difference_run<S, Careful>(pattern(shifted(rows, static_cast<float>(from))), groups - from, out + 24 * from);
}

// Writes the vertices after the last whole group, by Horner's rule counted in vertices.
inline void last_vertices(const GroupCoefficients& p, int points, float* out) {
  if (points >= kGroup) {  // repeat the last group so that it ends at the curve's end
    horner_groups<false>(p, points - kGroup, 1, out + static_cast<std::ptrdiff_t>(points - kGroup) * 3);
  } else {
    float few[24];
    horner_groups<false>(p, 0, 1, few);
    for (int i = 0; i < points * 3; ++i) out[i] = few[i];
  }
}

// Writes the vertices of all curves; the last of steps + 1 vertices is exactly p3.
template <bool Differences, bool S, bool Careful>
void run(const KernelJob& job) {
  const float inv = 1.0f / static_cast<float>(job.steps);
  const float* cubic = job.cubics;
  float* out = job.out;
  const int inner = job.points < job.steps ? job.points : job.steps, groups = inner / kGroup;
  const bool rest = groups * kGroup != inner;
  for (std::size_t i = 0; i < job.count; ++i, cubic += 24, out += static_cast<std::ptrdiff_t>(job.points) * 3) {
    if constexpr (Differences) difference_groups<S, Careful>(coefficients_of(cubic, kGroup * inv), groups, out);
    if (!Differences || rest) {
      const GroupCoefficients p = pattern(coefficients_of(cubic, inv));
      if constexpr (!Differences) horner_groups<S>(p, 0, groups, out);
      if (rest) last_vertices(p, inner, out);
    }
    if (job.points > inner)
      for (int a = 0; a < 3; ++a) out[static_cast<std::ptrdiff_t>(inner) * 3 + a] = cubic[9 + a];
  }
}

void positions_by_horner(const KernelJob& job) { run<false, false, false>(job); }
void positions_by_differences(const KernelJob& job) { run<true, false, true>(job); }
void track_positions(const KernelJob& job) { run<true, false, false>(job); }
void track_positions_streamed(const KernelJob& job) { run<true, true, false>(job); }

constexpr coaster::curve::detail::Kernels kKernels{positions_by_horner, positions_by_differences, track_positions,
                                                   track_positions_streamed};

}  // namespace
