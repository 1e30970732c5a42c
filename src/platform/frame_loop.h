// The loop of frames, which a browser runs itself.
#pragma once

#include <functional>

namespace coaster::platform {

// Calls `step` until it returns false, then returns the result of `finish`. In a web page it returns 0 at once: the
// browser continues to call `step`, and after the last one the program ends with the result of `finish`.
int run_frames(std::function<bool()> step, std::function<int()> finish);

}  // namespace coaster::platform
