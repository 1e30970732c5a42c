// Eight floats side by side for the vector kernels: one AVX register, or two of the baseline's. Included only by
// kernels_body.h, in an anonymous namespace for the same reason.
#pragma once

#if defined(__SSE2__)
#include <immintrin.h>
#endif

namespace {

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

}  // namespace
