// The kernels for the baseline instruction set of the whole program (SSE2 on x86-64).
#include "curve/kernels_tangents.h"

namespace coaster::curve::detail {

const Kernels& baseline_kernels() {
  static constexpr Kernels kernels{positions_by_horner,      positions_by_differences, track_positions,
                                   track_positions_streamed, track_vertices,           track_unit_tangents};
  return kernels;
}

}  // namespace coaster::curve::detail
