// What contexts of windows and of memory have in common.
#pragma once

namespace coaster::platform {

// Sets LP_NUM_THREADS to 0, unless it is set, if the system refuses as many threads as the machine has cores: the
// renderer does not notice a refused thread and waits for it forever. Call it before the first context.
void spare_driver_threads();

struct GlVersion {
  int major = 0, minor = 0;
};
inline constexpr GlVersion kGlVersions[] = {{4, 0}, {3, 3}};

}  // namespace coaster::platform
