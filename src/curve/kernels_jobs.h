// The interface from kernels.cpp and frames_batch.cpp to the kernels compiled for each instruction set. Plain pointers:
// these files share no library code.
#pragma once

#include <cstddef>

namespace coaster::curve::detail {

struct Job {
  const float* cubics;  // PreparedCubic as 24 floats: p0 p1 p2 p3, c0 c1 c2 c3
  std::size_t count;
  int steps;   // n
  int points;  // vertices of each curve: n, or n + 1 with p3 as the last
  float* out;  // count * points vertices
  // For track_unit_tangents: 1 for each curve whose tangents lose their direction to rounding.
  unsigned char* slow = nullptr;
};

// Groups between two restarts of the differences: a value accumulates at most kRun - 1 roundings.
inline constexpr int kRun = 8;

// A speed below this fraction of the derivative's size is too slow to normalise in float.
inline constexpr float kSlow = 1.0f / 64;

struct Kernels {
  void (*positions_by_horner)(const Job&);
  void (*positions_by_differences)(const Job&);  // the careful form
  void (*track_positions)(const Job&);           // the fast form
  void (*track_positions_streamed)(const Job&);  // `out` aligned to 32 bytes, points a multiple of 8
  void (*track_vertices)(const Job&);
  void (*track_unit_tangents)(const Job&);  // of the first n vertices of each curve; does not write a polyline's last
};

const Kernels& baseline_kernels();
#ifdef COASTER_AVX2_KERNELS
const Kernels& avx2_kernels();  // requires a processor with AVX2 and FMA
#endif

// Eight chains of `count` points each, one chain after the other, three doubles per point. ups[chain][0] is given.
struct FrameJob {
  const double* points;
  const double* tangents;
  double* ups;
  long count;
  bool* bad;  // eight flags: the chain has a point that transport() handles by a branch
};

void transport_eight_baseline(const FrameJob& job);
#ifdef COASTER_AVX2_KERNELS
void transport_eight_avx2(const FrameJob& job);
#endif

}  // namespace coaster::curve::detail
