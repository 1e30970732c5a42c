// Float4 floats side by side: one register of every x86-64 processor and of most others. Picking gives the same result
// with each.
#pragma once

#include <array>
#include <bit>

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

namespace coaster::view {

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

}  // namespace coaster::view
