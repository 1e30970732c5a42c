#include "platform/lost_display.h"

#include <dlfcn.h>

#include <utility>

namespace coaster::platform {
namespace {

// Xlib's handler gets no argument, so this is global.
std::function<void()>& lost_handler() {
  static std::function<void()> handler;
  return handler;
}

void call_lost() {
  // At most once: the handler may be called again if it uses the display.
  if (const auto handler = std::exchange(lost_handler(), {})) handler();
}

extern "C" int note_lost(void*) {
  call_lost();
  return 0;
}

// Returns a function of a library that GLFW has loaded; null without that library.
template <class Function>
Function* loaded(const char* library, const char* name) {
  void* const handle = dlopen(library, RTLD_LAZY | RTLD_NOLOAD);
  return handle ? reinterpret_cast<Function*>(dlsym(handle, name)) : nullptr;
}

}  // namespace

void watch_display(std::function<void()> lost) {
  lost_handler() = std::move(lost);
  if (!lost_handler()) return;
  using SetHandler = void*(int (*)(void*));
  if (const auto set = loaded<SetHandler>("libX11.so.6", "XSetIOErrorHandler")) set(note_lost);
}

void check_display() {
  if (!lost_handler()) return;
  using Display = void*();
  using Error = int(void*);
  static const auto display = reinterpret_cast<Display*>(dlsym(RTLD_DEFAULT, "glfwGetWaylandDisplay"));
  static const auto error = loaded<Error>("libwayland-client.so.0", "wl_display_get_error");
  void* const connection = display && error ? display() : nullptr;
  if (connection && error(connection) != 0) call_lost();
}

}  // namespace coaster::platform
