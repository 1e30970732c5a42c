// Lets Mesa's software renderer work where the system refuses threads.
#pragma once

namespace coaster::platform {

// Sets LP_NUM_THREADS to 0, unless it is set, if the system refuses as many threads as the machine has cores: the
// renderer does not notice a refused thread and waits for it forever. Call it before the first context.
void spare_driver_threads();

}  // namespace coaster::platform
