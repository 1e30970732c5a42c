// Eight chains of frames with AVX2, without FMA: the same bits as everywhere.
#ifdef COASTER_AVX2_KERNELS

#include "curve/kernels_frames_body.h"

namespace coaster::curve::detail {

void transport_eight_avx2(const FrameJob& job) { transport_eight(job); }

}  // namespace coaster::curve::detail

#endif
