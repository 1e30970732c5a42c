// make_window for a program built without windows.
#include "platform/surface.h"

namespace coaster::platform {

base::Result<std::unique_ptr<Surface>> make_window(const SurfaceOptions&) {
  return base::Status{base::Code::graphics, "this program was built without windows; use --headless"};
}

std::string window_library() { return "none"; }

}  // namespace coaster::platform
