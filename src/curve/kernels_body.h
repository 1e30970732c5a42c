// The bodies of the vector kernels, compiled once per instruction set (kernels_avx2.cpp, kernels_baseline.cpp);
// included by no other files. Everything is in an anonymous namespace and no library header is used, so the linker
// cannot mix code for different processors.
//
// A vertex is W floats (3: position; 6: position and tangent), each its own cubic in u = 0, 1, .. n, t = u/n, with
// coefficients scaled by powers of 1/n. 24 floats are three vectors of eight, which hold 8 positions or 4 vertices of 6
// floats. Coefficients are in the order of the vertices' floats, so results are stored without a shuffle.
#pragma once

#include <cstddef>

#include "curve/kernels_jobs.h"
#include "curve/kernels_lanes.h"

namespace {

using coaster::curve::detail::Job;

// The coefficients of one cubic, lanes x y z (the fourth lane is arbitrary).
struct Rows {
  V4 c[4];
};
// Coefficients start at float 12 of a PreparedCubic; c3 is loaded one float early, so that nothing past the end is
// read.
inline Rows rows_of(const float* cubic, float e) {
  const V4 c3 = load4(cubic + 20);
  return {{load4(cubic + 12), load4(cubic + 15) * e, load4(cubic + 18) * (e * e),
           __builtin_shufflevector(c3, c3, 1, 2, 3, 3) * (e * e * e)}};
}
// Returns the same cubic with its parameter counted from w.
inline Rows shifted(const Rows& r, float w) {
  const V4 a = r.c[2] + r.c[3] * w, b = a + r.c[3] * w, d = r.c[1] + a * w;
  return {{r.c[0] + d * w, d + b * w, b + r.c[3] * w, r.c[3]}};
}

// c[k][i]: coefficient i in the lanes of vector k of a group.
struct Pattern {
  V8 c[3][4];
};
inline Pattern pattern(const Rows& rows) {
  Pattern p;
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
// Positions and tangents alternately; `scale` turns the derivative by the rows' parameter into B'(t).
inline Pattern pattern(const Rows& rows, float scale) {
  const Rows d{{rows.c[1] * scale, rows.c[2] * (2 * scale), rows.c[3] * (3 * scale), V4{}}};
  Pattern p;
  for (int i = 0; i < 4; ++i) {
    const V4 a = rows.c[i], b = d.c[i];
#ifdef __AVX2__
    const V8 w = join(a, b);
    p.c[0][i] = _mm256_permutevar8x32_ps(w, _mm256_setr_epi32(0, 1, 2, 4, 5, 6, 0, 1));
    p.c[1][i] = _mm256_permutevar8x32_ps(w, _mm256_setr_epi32(2, 4, 5, 6, 0, 1, 2, 4));
    p.c[2][i] = _mm256_permutevar8x32_ps(w, _mm256_setr_epi32(5, 6, 0, 1, 2, 4, 5, 6));
#else
    const V4 pt0 = __builtin_shufflevector(a, b, 0, 1, 2, 4), pt1 = __builtin_shufflevector(b, a, 1, 2, 4, 5);
    const V4 pt2 = __builtin_shufflevector(a, b, 2, 4, 5, 6);
    p.c[0][i] = join(pt0, pt1);
    p.c[1][i] = join(pt2, pt0);
    p.c[2][i] = join(pt1, pt2);
#endif
  }
  return p;
}

// The vertex number of each float of a group.
template <int W>
inline V8 vertex_numbers(int k) {
  static const float three[24] = {0, 0, 0, 1, 1, 1, 2, 2, 2, 3, 3, 3, 4, 4, 4, 5, 5, 5, 6, 6, 6, 7, 7, 7};
  static const float six[24] = {0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1, 2, 2, 2, 2, 2, 2, 3, 3, 3, 3, 3, 3};
  return load((W == 3 ? three : six) + 8 * k);
}

inline V8 horner(const V8* c, V8 w) { return c[0] + w * (c[1] + w * (c[2] + w * c[3])); }

// Differences of a cubic in w, one group long, for step 1: value, first, second, third. The polynomials in w are
// constants.
template <int W>
struct Starts {
  alignas(32) float w[24], first2[24], first3[24], second3[24];
  constexpr Starts() : w(), first2(), first3(), second3() {
    for (int i = 0; i < 24; ++i) {
      const int vertex = i / W;
      const float x = static_cast<float>(vertex) * (W / 24.0f);
      w[i] = x;
      first2[i] = 2 * x + 1;
      first3[i] = 3 * x * x + 3 * x + 1;
      second3[i] = 6 * x + 6;
    }
  }
};
template <int W>
inline constexpr Starts<W> kStarts{};

struct State {
  V8 value, first, second, third;
};
template <int W>
inline State start(const V8* c, int k) {
  const Starts<W>& s = kStarts<W>;
  return {horner(c, load(s.w + 8 * k)), c[1] + load(s.first2 + 8 * k) * c[2] + load(s.first3 + 8 * k) * c[3],
          c[2] + c[2] + load(s.second3 + 8 * k) * c[3], all(6) * c[3]};
}
inline void advance(State& s) {
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
template <int W, bool S>
inline void horner_groups(const Pattern& p, int first, int groups, float* out) {
  constexpr int a_group = 24 / W;
  V8 u[3];
  for (int k = 0; k < 3; ++k) u[k] = vertex_numbers<W>(k) + all(static_cast<float>(first));
  for (int g = 0; g < groups; ++g, out += 24)
    for (int k = 0; k < 3; ++k) {
      put<S>(out + 8 * k, horner(p.c[k], u[k]));
      u[k] = u[k] + all(static_cast<float>(a_group));
    }
}

// Writes `groups` groups by differences; each lane steps one whole group. Careful: values are relative to the run's
// first point, which is added when storing, so each value rounds only once at the size of the coordinates, for one more
// addition.
template <int W, bool S, bool Careful>
inline void difference_run(Pattern p, int groups, float* out) {
  const V8 base0 = p.c[0][0], base1 = p.c[1][0], base2 = p.c[2][0];
  if constexpr (Careful)
    for (int k = 0; k < 3; ++k) p.c[k][0] = all(0);
  State a = start<W>(p.c[0], 0), b = start<W>(p.c[1], 1), c = start<W>(p.c[2], 2);
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

template <int W>
inline Pattern pattern_of(const Rows& rows, float scale) {
  if constexpr (W == 3) return pattern(rows);
  else return pattern(rows, scale);
}

// Writes all groups, restarting every kRun groups from the cubic shifted there. Whole runs have a fixed length.
template <int W, bool S, bool Careful>
inline void difference_groups(const Rows& rows, float scale, int groups, float* out) {
  constexpr int run = coaster::curve::detail::kRun;
  if (groups >= run) difference_run<W, S, Careful>(pattern_of<W>(rows, scale), run, out);
  int from = groups >= run ? run : 0;
  for (; from + run <= groups; from += run)
    difference_run<W, S, Careful>(pattern_of<W>(shifted(rows, static_cast<float>(from)), scale), run, out + 24 * from);
  if (from < groups)
    difference_run<W, S, Careful>(pattern_of<W>(shifted(rows, static_cast<float>(from)), scale), groups - from,
                                  out + 24 * from);
}

// Writes the vertices after the last whole group, by Horner's rule counted in vertices.
template <int W>
inline void last_vertices(const Pattern& p, int points, float* out) {
  constexpr int a_group = 24 / W;
  if (points >= a_group) {  // repeat the last group so that it ends at the curve's end
    horner_groups<W, false>(p, points - a_group, 1, out + static_cast<std::ptrdiff_t>(points - a_group) * W);
  } else {
    float few[24];
    horner_groups<W, false>(p, 0, 1, few);
    for (int i = 0; i < points * W; ++i) out[i] = few[i];
  }
}

// Writes the last vertex of a curve of steps + 1 vertices: exactly p3, and B'(1) = 3 (p3 - p2).
template <int W>
inline void end_vertex(const float* cubic, float* vertex) {
  for (int a = 0; a < 3; ++a) vertex[a] = cubic[9 + a];
  if constexpr (W == 6)
    for (int a = 0; a < 3; ++a) vertex[3 + a] = 3 * (cubic[9 + a] - cubic[6 + a]);
}

template <int W, bool Differences, bool S, bool Careful>
void run(const Job& job) {
  constexpr int a_group = 24 / W;
  const float n = static_cast<float>(job.steps), inv = 1.0f / n;
  const float* cubic = job.cubics;
  float* out = job.out;
  const int inner = job.points < job.steps ? job.points : job.steps, groups = inner / a_group;
  const bool rest = groups * a_group != inner;
  for (std::size_t i = 0; i < job.count; ++i, cubic += 24, out += static_cast<std::ptrdiff_t>(job.points) * W) {
    if constexpr (Differences)
      difference_groups<W, S, Careful>(rows_of(cubic, a_group * inv), n / a_group, groups, out);
    if (!Differences || rest) {
      const Pattern p = pattern_of<W>(rows_of(cubic, inv), n);
      if constexpr (!Differences) horner_groups<W, S>(p, 0, groups, out);
      if (rest) last_vertices<W>(p, inner, out);
    }
    if (job.points > inner) end_vertex<W>(cubic, out + static_cast<std::ptrdiff_t>(inner) * W);
  }
}

void positions_by_horner(const Job& job) { run<3, false, false, false>(job); }
void positions_by_differences(const Job& job) { run<3, true, false, true>(job); }
void track_positions(const Job& job) { run<3, true, false, false>(job); }
void track_positions_streamed(const Job& job) { run<3, true, true, false>(job); }
void track_vertices(const Job& job) { run<6, true, false, false>(job); }

}  // namespace
