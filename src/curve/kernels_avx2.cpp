// The kernels for AVX2 and FMA: compiled with those flags (cmake/kernels.cmake), called only if the processor has them.
#ifdef COASTER_AVX2_KERNELS

#include "curve/kernels_body.h"

namespace coaster::curve::detail {

const Kernels& avx2_kernels() { return kKernels; }

}  // namespace coaster::curve::detail

#endif
