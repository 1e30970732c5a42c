// Eight chains of frames with the baseline instruction set.
#include "curve/kernels_frames_body.h"

namespace coaster::curve::detail {

void transport_eight_baseline(const FrameJob& job) { transport_eight(job); }

}  // namespace coaster::curve::detail
