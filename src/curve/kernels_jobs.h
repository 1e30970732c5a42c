// The interface from kernels.cpp to the kernels compiled for each instruction set. Plain pointers: these files share no
// library code.
#pragma once

#include <cstddef>

namespace coaster::curve::detail {

struct KernelJob {
  const float* cubics;  // PreparedCubic as 24 floats: p0 p1 p2 p3, c0 c1 c2 c3
  std::size_t count;
  int steps;   // n
  int points;  // vertices of each curve: n, or n + 1 with p3 as the last
  float* out;  // count * points vertices
};

// Groups between two restarts of the differences: a value accumulates at most kRun - 1 roundings.
inline constexpr int kRun = 8;

struct Kernels {
  void (*positions_by_horner)(const KernelJob&);
  void (*positions_by_differences)(const KernelJob&);  // the careful form
  void (*track_positions)(const KernelJob&);           // the fast form
  void (*track_positions_streamed)(const KernelJob&);  // `out` aligned to 32 bytes, points a multiple of 8
};

const Kernels& baseline_kernels();
#ifdef COASTER_AVX2_KERNELS
const Kernels& avx2_kernels();  // requires a processor with AVX2 and FMA
#endif

}  // namespace coaster::curve::detail
