#include "platform/loop.h"

namespace coaster::platform {

// NOLINTNEXTLINE(performance-unnecessary-value-param): a web page keeps them
int run_frames(std::function<bool()> step, std::function<int()> finish) {
  while (step()) {
  }
  return finish();
}

}  // namespace coaster::platform
