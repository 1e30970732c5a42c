// What frames_batch.cpp hands to the kernels compiled for each processor. Plain pointers: these files share no library
// code.
#pragma once

namespace coaster::curve::detail {

// Eight chains of `count` places each, one chain after the other, three doubles a place. ups[chain][0] is given.
struct FrameJob {
  const double* points;
  const double* tangents;
  double* ups;
  long count;
  bool* bad;  // eight: a chain that met a place which transport() treats apart
};

void transport_eight_baseline(const FrameJob& job);
#ifdef COASTER_AVX2_KERNELS
void transport_eight_avx2(const FrameJob& job);
#endif

}  // namespace coaster::curve::detail
