// The kernels for the baseline instruction set of the whole program (SSE2 on x86-64).
#include "curve/kernels_body.h"

namespace coaster::curve::detail {

const Kernels& baseline_kernels() { return kKernels; }

}  // namespace coaster::curve::detail
