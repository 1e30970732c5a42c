// Double reflection for eight chains of frames at once, compiled once per instruction set (kernels_frames_*.cpp);
// included by no other files. The operations and their order are those of transport() in frames.cpp, without fused
// multiply-add, so each lane has the same bits. Lanes that would take one of its branches are reported; the caller runs
// transport() for them.
#pragma once

#include "curve/kernels_jobs.h"

#if defined(__SSE2__)
#include <immintrin.h>
#endif

namespace {

using coaster::curve::detail::FrameJob;

#ifdef __AVX2__
typedef double Part __attribute__((vector_size(32)));
typedef long long PartMask __attribute__((vector_size(32)));
constexpr int kPartLanes = 4;
inline Part root(Part x) { return _mm256_sqrt_pd(x); }
#else
typedef double Part __attribute__((vector_size(16)));
typedef long long PartMask __attribute__((vector_size(16)));
constexpr int kPartLanes = 2;
#if defined(__SSE2__)
inline Part root(Part x) { return _mm_sqrt_pd(x); }
#else
inline Part root(Part x) { return Part{__builtin_sqrt(x[0]), __builtin_sqrt(x[1])}; }
#endif
#endif

// Eight lanes in parts. Each operation runs on all parts in turn, so that divisions and roots of the parts overlap.
constexpr int kParts = 8 / kPartLanes;
struct Wide {
  Part v[kParts];
};
// Always inlined: a vector that crosses a call goes through memory.
#define COASTER_INLINE inline __attribute__((always_inline))
#define COASTER_EACH_PART _Pragma("GCC unroll 4") for (int q = 0; q < kParts; ++q)
COASTER_INLINE Wide operator+(Wide a, Wide b) {
  COASTER_EACH_PART a.v[q] = a.v[q] + b.v[q];
  return a;
}
COASTER_INLINE Wide operator-(Wide a, Wide b) {
  COASTER_EACH_PART a.v[q] = a.v[q] - b.v[q];
  return a;
}
COASTER_INLINE Wide operator*(Wide a, Wide b) {
  COASTER_EACH_PART a.v[q] = a.v[q] * b.v[q];
  return a;
}
COASTER_INLINE Wide operator/(Wide a, Wide b) {
  COASTER_EACH_PART a.v[q] = a.v[q] / b.v[q];
  return a;
}
COASTER_INLINE Wide root(Wide a) {
  COASTER_EACH_PART a.v[q] = root(a.v[q]);
  return a;
}
COASTER_INLINE Wide all(double x) {
  Wide a;
  COASTER_EACH_PART a.v[q] = Part{} + x;
  return a;
}

struct Vec {
  Wide x, y, z;
};
COASTER_INLINE Wide dot(Vec a, Vec b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
COASTER_INLINE Vec operator-(Vec a, Vec b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
COASTER_INLINE Vec operator*(Wide k, Vec a) { return {k * a.x, k * a.y, k * a.z}; }
COASTER_INLINE Vec operator/(Vec a, Wide k) { return {a.x / k, a.y / k, a.z / k}; }

// One point of eight chains that are `stride` doubles apart.
COASTER_INLINE Vec gather(const double* p, long stride) {
  Vec out;
  COASTER_EACH_PART for (int l = 0; l < kPartLanes; ++l) {
    const double* at = p + (q * kPartLanes + l) * stride;
    out.x.v[q][l] = at[0];
    out.y.v[q][l] = at[1];
    out.z.v[q][l] = at[2];
  }
  return out;
}
COASTER_INLINE void scatter(double* p, long stride, Vec a) {
  COASTER_EACH_PART for (int l = 0; l < kPartLanes; ++l) {
    double* at = p + (q * kPartLanes + l) * stride;
    at[0] = a.x.v[q][l];
    at[1] = a.y.v[q][l];
    at[2] = a.z.v[q][l];
  }
}

// Wang et al. 2008, in the operation order of transport().
void transport_eight(const FrameJob& job) {
  const long stride = 3 * job.count;
  Vec x0 = gather(job.points, stride), t0 = gather(job.tangents, stride), up = gather(job.ups, stride);
  PartMask bad[kParts] = {};
  for (long i = 1; i < job.count; ++i) {
    const Vec x1 = gather(job.points + 3 * i, stride), t1 = gather(job.tangents + 3 * i, stride);
    const Vec v1 = x1 - x0;
    const Wide c1 = dot(v1, v1), k1 = all(2.0) / c1;
    const Vec v2 = t1 - (t0 - k1 * dot(v1, t0) * v1);
    const Wide c2 = dot(v2, v2), k2 = all(2.0) / c2;
    up = up - k1 * dot(v1, up) * v1;
    up = up - k2 * dot(v2, up) * v2;
    up = up - dot(up, t1) * t1;
    const Wide length = root(dot(up, up));
    up = up / length;
    up = up - dot(up, t1) * t1;
    up = up / root(dot(up, up));
    COASTER_EACH_PART bad[q] |=
        ~((c1.v[q] > Part{} + 1e-24) & (c2.v[q] > Part{} + 1e-24) & (length.v[q] > Part{} + 1e-9));
    scatter(job.ups + 3 * i, stride, up);
    x0 = x1;
    t0 = t1;
  }
  for (int l = 0; l < 8; ++l) job.bad[l] = bad[l / kPartLanes][l % kPartLanes] != 0;
}

#undef COASTER_EACH_PART
#undef COASTER_INLINE

}  // namespace
