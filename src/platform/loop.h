// The loop of a window's frames. A browser runs it itself, between the frames of its page.
#pragma once

#include <functional>

namespace coaster::platform {

// Calls `step` until it returns false, then returns what `finish` returns. In a page it returns 0 at once: the browser
// goes on calling, and the program ends with that number after the last step.
int run_frames(std::function<bool()> step, std::function<int()> finish);

}  // namespace coaster::platform
