// OpenGL contexts without a window, each from a library that is loaded at run time, so that the build needs neither
// library and a window needs no software renderer.
#pragma once

#include <dlfcn.h>

#include <fmt/format.h>

#include <functional>
#include <initializer_list>
#include <string>

#include "base/status.h"

namespace coaster::platform {

// A context that has been made current. Nothing is drawn into its own buffer: frames are in the renderer's framebuffer.
struct OffscreenContext {
  std::function<void*(const char*)> proc;
  std::function<void()> destroy;
};

// Makes a context with Mesa's OSMesa, OpenGL 3.3 core: software only. Mesa dropped it in version 25.1.
base::Result<OffscreenContext> make_osmesa_context();
// Makes a context with EGL on Mesa's surfaceless platform: the graphics card if there is one, else software. OpenGL 3.3
// core, or with `es` OpenGL ES 3.0, which is what a browser offers.
base::Result<OffscreenContext> make_egl_context(bool es);

// Loads the first library found; Code::graphics with the reason if none can be loaded. It stays loaded, because its
// threads and atexit handlers need their code.
inline base::Result<void*> load_first(std::initializer_list<const char*> names) {
  std::string reason;
  for (const char* const name : names) {
    if (void* const library = dlopen(name, RTLD_NOW | RTLD_LOCAL)) return library;
    const std::string why = dlerror();
    const bool missing = why.starts_with(name) && why.find("No such file") != std::string::npos;
    if (!missing) reason = fmt::format("{} cannot be loaded ({})", name, why);
    if (!missing) break;
    if (reason.empty()) reason = fmt::format("{} was not found", name);
  }
  return base::Status{base::Code::graphics, reason};
}

// Loads a function. Returns false if the library has no such function.
template <class F>
bool look_up(void* library, const char* name, F& function) {
  function = reinterpret_cast<F>(dlsym(library, name));
  return function != nullptr;
}

}  // namespace coaster::platform
