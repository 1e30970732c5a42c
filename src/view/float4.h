// Four floats side by side: one register of every x86-64 processor and of most others. Picking gives the same result
// with each.
#pragma once

#include <array>
#include <cstring>

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

namespace coaster::view {

typedef float Four __attribute__((vector_size(16)));
typedef int FourTruths __attribute__((vector_size(16)));  // 0 (false) or -1 (true) per lane

inline Four all(float x) { return Four{x, x, x, x}; }
inline void store(Four x, std::array<float, 4>& out) { std::memcpy(out.data(), &x, sizeof x); }
inline Four load(const std::array<float, 4>& x) {
  Four out;
  std::memcpy(&out, x.data(), sizeof out);
  return out;
}

#if defined(__SSE2__)
inline Four least(Four a, Four b) { return _mm_min_ps(a, b); }
inline Four greatest(Four a, Four b) { return _mm_max_ps(a, b); }
inline unsigned bits_of(FourTruths t) { return static_cast<unsigned>(_mm_movemask_ps(reinterpret_cast<__m128>(t))); }
#else
inline Four least(Four a, Four b) { return a < b ? a : b; }
inline Four greatest(Four a, Four b) { return a > b ? a : b; }
inline unsigned bits_of(FourTruths t) { return (t[0] & 1u) | (t[1] & 2u) | (t[2] & 4u) | (t[3] & 8u); }
#endif

inline Four size(Four x) { return greatest(x, -x); }

}  // namespace coaster::view
