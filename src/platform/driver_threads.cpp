#include "platform/driver_threads.h"

#include <atomic>
#include <cstdlib>
#include <system_error>
#include <thread>
#include <vector>

#include "base/parallel.h"

namespace coaster::platform {

void spare_driver_threads() {
  std::atomic<bool> counted = false;
  std::vector<std::jthread> threads;  // they live at the same time, as the renderer's do
  try {
    while (threads.size() < base::cores()) threads.emplace_back([&counted] { counted.wait(false); });
  } catch (const std::system_error&) {
    setenv("LP_NUM_THREADS", "0", 0);
  }
  counted = true;
  counted.notify_all();
}

}  // namespace coaster::platform
