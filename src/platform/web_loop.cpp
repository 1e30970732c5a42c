// The browser's loop, which runs before each repaint of the page.
#include <emscripten.h>

#include <utility>

#include "platform/loop.h"

namespace coaster::platform {
namespace {

struct Loop {
  std::function<bool()> step;
  std::function<int()> finish;
};

void run_step(void* data) {
  Loop* const loop = static_cast<Loop*>(data);
  if (loop->step()) return;
  emscripten_cancel_main_loop();
  const int code = loop->finish();
  delete loop;
  emscripten_force_exit(code);
}

}  // namespace

int run_frames(std::function<bool()> step, std::function<int()> finish) {
  emscripten_set_main_loop_arg(run_step, new Loop{std::move(step), std::move(finish)}, 0, 0);
  return 0;
}

}  // namespace coaster::platform
