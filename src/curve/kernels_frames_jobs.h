// The interface from frames_batch.cpp to the kernels compiled for each instruction set. Plain pointers: these files
// share no library code.
#pragma once

namespace coaster::curve::detail {

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
