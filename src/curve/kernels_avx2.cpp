// The kernels for AVX2 and FMA: compiled with those flags (cmake/kernels.cmake), called only if the processor has them.
#ifdef COASTER_AVX2_KERNELS

#include "curve/kernels_tangents.h"

namespace coaster::curve::detail {

const Kernels& avx2_kernels() {
  static constexpr Kernels kernels{positions_by_horner,      positions_by_differences, track_positions,
                                   track_positions_streamed, track_vertices,           track_unit_tangents};
  return kernels;
}

}  // namespace coaster::curve::detail

#endif
