#define EGL_NO_X11
#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <string>
#include <string_view>

#include <fmt/format.h>

#include "platform/gl_versions.h"
#include "platform/offscreen_context.h"

namespace coaster::platform {
namespace {

struct Egl {
  decltype(&eglGetError) error = nullptr;
  decltype(&eglQueryString) query = nullptr;
  decltype(&eglGetPlatformDisplay) display = nullptr;
  decltype(&eglInitialize) initialize = nullptr;
  decltype(&eglBindAPI) bind = nullptr;
  decltype(&eglChooseConfig) choose = nullptr;
  decltype(&eglCreateContext) create = nullptr;
  decltype(&eglDestroyContext) destroy = nullptr;
  decltype(&eglCreatePbufferSurface) create_buffer = nullptr;
  decltype(&eglDestroySurface) destroy_buffer = nullptr;
  decltype(&eglMakeCurrent) make_current = nullptr;
  decltype(&eglGetProcAddress) proc = nullptr;
};

base::Result<Egl> load_egl() {
  const base::Result<void*> loaded = load_first({"libEGL.so.1"});
  if (!loaded) return loaded.status();
  void* const library = *loaded;
  Egl egl;
  if (!look_up(library, "eglGetError", egl.error) || !look_up(library, "eglQueryString", egl.query) ||
      !look_up(library, "eglGetPlatformDisplay", egl.display) || !look_up(library, "eglInitialize", egl.initialize) ||
      !look_up(library, "eglBindAPI", egl.bind) || !look_up(library, "eglChooseConfig", egl.choose) ||
      !look_up(library, "eglCreateContext", egl.create) || !look_up(library, "eglDestroyContext", egl.destroy) ||
      !look_up(library, "eglCreatePbufferSurface", egl.create_buffer) ||
      !look_up(library, "eglDestroySurface", egl.destroy_buffer) ||
      !look_up(library, "eglMakeCurrent", egl.make_current) || !look_up(library, "eglGetProcAddress", egl.proc))
    return base::Status{base::Code::graphics, "libEGL is older than EGL 1.5"};
  return egl;
}

bool has(const char* extensions, std::string_view wanted) {
  return extensions != nullptr && std::string_view(extensions).find(wanted) != std::string_view::npos;
}

// One display for all contexts. It is never terminated: that would take the contexts of other surfaces with it.
EGLDisplay open_display(const Egl& egl) {
  if (!has(egl.query(EGL_NO_DISPLAY, EGL_EXTENSIONS), "EGL_MESA_platform_surfaceless")) return EGL_NO_DISPLAY;
  const EGLDisplay display = egl.display(EGL_PLATFORM_SURFACELESS_MESA, nullptr, nullptr);
  return display != EGL_NO_DISPLAY && egl.initialize(display, nullptr, nullptr) ? display : EGL_NO_DISPLAY;
}

// A context with a separate buffer, as small as possible: without one, transform feedback is an error in Mesa.
struct Made {
  EGLDisplay display = EGL_NO_DISPLAY;
  EGLContext context = EGL_NO_CONTEXT;
  EGLSurface buffer = EGL_NO_SURFACE;
};

// Returns no context if the driver lacks the version: OpenGL core, or with `es` OpenGL ES.
Made create(const Egl& egl, EGLDisplay display, bool es, int major, int minor) {
  const EGLint wanted[] = {EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE,
                           es ? EGL_OPENGL_ES3_BIT : EGL_OPENGL_BIT, EGL_NONE};
  const EGLint version[] = {EGL_CONTEXT_MAJOR_VERSION,
                            major,
                            EGL_CONTEXT_MINOR_VERSION,
                            minor,
                            es ? EGL_NONE : EGL_CONTEXT_OPENGL_PROFILE_MASK,
                            EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                            EGL_NONE};
  const EGLint size[] = {EGL_WIDTH, 16, EGL_HEIGHT, 16, EGL_NONE};
  EGLConfig config = nullptr;
  EGLint count = 0;
  Made made{.display = display};
  if (!egl.bind(es ? EGL_OPENGL_ES_API : EGL_OPENGL_API) || !egl.choose(display, wanted, &config, 1, &count) ||
      count < 1)
    return made;
  made.context = egl.create(display, config, EGL_NO_CONTEXT, version);
  if (made.context != EGL_NO_CONTEXT) made.buffer = egl.create_buffer(display, config, size);
  return made;
}

// Returns the first of kGlVersions that the driver provides, or with `es` OpenGL ES 3.0.
Made create_best(const Egl& egl, EGLDisplay display, bool es) {
  Made made{.display = display};
  if (es) return create(egl, display, true, 3, 0);
  for (const GlVersion version : kGlVersions)
    if (made.context == EGL_NO_CONTEXT) made = create(egl, display, false, version.major, version.minor);
  return made;
}

bool bind(const Egl& egl, const Made& made) {
  return egl.make_current(made.display, made.buffer, made.buffer, made.context) == EGL_TRUE;
}

void destroy(const Egl& egl, const Made& made) {
  egl.make_current(made.display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  egl.destroy(made.display, made.context);
  if (made.buffer != EGL_NO_SURFACE) egl.destroy_buffer(made.display, made.buffer);
}

// Returns the version of a driver that rejected 3.3, for the error message.
std::string version_at_hand(const Egl& egl, EGLDisplay display) {
  constexpr unsigned kVersion = 0x1f02;  // GL_VERSION
  for (const int minor : {2, 1, 0}) {
    const Made made = create(egl, display, false, 3, minor);
    if (made.context == EGL_NO_CONTEXT) continue;
    const auto get_string = reinterpret_cast<const unsigned char* (*)(unsigned)>(egl.proc("glGetString"));
    const unsigned char* const text = get_string && bind(egl, made) ? get_string(kVersion) : nullptr;
    const std::string version = text ? reinterpret_cast<const char*>(text) : "an unknown version";
    destroy(egl, made);
    return version;
  }
  return fmt::format("none (error {:#x})", egl.error());
}

}  // namespace

base::Result<OffscreenContext> make_egl_context(bool es) {
  const auto loaded = load_egl();
  if (!loaded) return loaded.status();
  const Egl egl = *loaded;
  const EGLDisplay display = open_display(egl);
  if (display == EGL_NO_DISPLAY)
    return base::Status{base::Code::graphics, "EGL has no display of Mesa's surfaceless platform"};
  const Made made = create_best(egl, display, es);
  if (made.context == EGL_NO_CONTEXT && es)
    return base::Status{base::Code::graphics, fmt::format("EGL has no OpenGL ES 3.0 (error {:#x})", egl.error())};
  if (made.context == EGL_NO_CONTEXT)
    return base::Status{base::Code::graphics, "OpenGL 3.3 is needed, EGL has " + version_at_hand(egl, display)};
  if (!bind(egl, made)) {
    const auto error = egl.error();
    destroy(egl, made);
    return base::Status{base::Code::graphics, fmt::format("EGL could not make its context current ({:#x})", error)};
  }
  return OffscreenContext{[egl](const char* name) { return reinterpret_cast<void*>(egl.proc(name)); },
                          [egl, made] { destroy(egl, made); }};
}

}  // namespace coaster::platform
