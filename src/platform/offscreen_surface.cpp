// The off-screen surface: a context without a window, of one of the libraries that are loaded at run time, so that the
// build needs neither library and a window needs no software renderer; and a size.
#define EGL_NO_X11
#include <dlfcn.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cstdlib>
#include <functional>
#include <initializer_list>
#include <memory>
#include <string>
#include <string_view>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <fmt/format.h>

#include "base/parallel.h"
#include "base/status.h"
#include "platform/gl_context_detail.h"
#include "platform/surface.h"

namespace coaster::platform {
namespace {

// A context that has been made current. Nothing is drawn into its own buffer: frames are in the renderer's framebuffer.
struct OffscreenContext {
  std::function<void*(const char*)> proc;
  std::function<void()> destroy;
};

// Loads the first library found; Code::graphics with the reason if none can be loaded. It stays loaded, because its
// threads and atexit handlers need their code.
base::Result<void*> load_first(std::initializer_list<const char*> names) {
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

// X(member, function)
// clang-format off
#define COASTER_EGL(X) \
  X(error, eglGetError) X(query, eglQueryString) X(display, eglGetPlatformDisplay) X(initialize, eglInitialize) \
  X(bind, eglBindAPI) X(choose, eglChooseConfig) X(create, eglCreateContext) X(destroy, eglDestroyContext) \
  X(create_buffer, eglCreatePbufferSurface) X(destroy_buffer, eglDestroySurface) X(make_current, eglMakeCurrent) \
  X(proc, eglGetProcAddress)
// clang-format on
struct Egl {
#define X(member, function) decltype(&(function)) member = nullptr;
  COASTER_EGL(X)
#undef X
};

base::Result<Egl> load_egl() {
  const base::Result<void*> library = load_first({"libEGL.so.1"});
  if (!library) return library.status();
  Egl egl;
  bool whole = true;
#define X(member, function) whole = look_up(*library, #function, egl.member) && whole;
  COASTER_EGL(X)
#undef X
  if (!whole) return base::Status{base::Code::graphics, "libEGL is older than EGL 1.5"};
  return egl;
}

// Returns the version of the present context's driver by its glGetString; null: it has none.
std::string version_by(void (*get_string)()) {
  constexpr unsigned kVersion = 0x1f02;  // GL_VERSION
  const auto call = reinterpret_cast<const unsigned char* (*)(unsigned)>(get_string);
  const unsigned char* const text = call ? call(kVersion) : nullptr;
  return text ? reinterpret_cast<const char*>(text) : "an unknown version";
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
struct EglResources {
  EGLDisplay display = EGL_NO_DISPLAY;
  EGLContext context = EGL_NO_CONTEXT;
  EGLSurface buffer = EGL_NO_SURFACE;
};

// Returns no context if the driver lacks the version: OpenGL core, or with `es` OpenGL ES.
EglResources create(const Egl& egl, EGLDisplay display, bool es, int major, int minor) {
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
  EglResources made{.display = display};
  if (!egl.bind(es ? EGL_OPENGL_ES_API : EGL_OPENGL_API) || !egl.choose(display, wanted, &config, 1, &count) ||
      count < 1)
    return made;
  made.context = egl.create(display, config, EGL_NO_CONTEXT, version);
  if (made.context != EGL_NO_CONTEXT) made.buffer = egl.create_buffer(display, config, size);
  return made;
}

// Returns the first of kGlVersions that the driver provides, or with `es` OpenGL ES 3.0.
EglResources create_best(const Egl& egl, EGLDisplay display, bool es) {
  EglResources made{.display = display};
  if (es) return create(egl, display, true, 3, 0);
  for (const GlVersion version : kGlVersions)
    if (made.context == EGL_NO_CONTEXT) made = create(egl, display, false, version.major, version.minor);
  return made;
}

bool bind(const Egl& egl, const EglResources& made) {
  return egl.make_current(made.display, made.buffer, made.buffer, made.context) == EGL_TRUE;
}

void destroy(const Egl& egl, const EglResources& made) {
  egl.make_current(made.display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  egl.destroy(made.display, made.context);
  if (made.buffer != EGL_NO_SURFACE) egl.destroy_buffer(made.display, made.buffer);
}

// Returns the version of a driver that rejected 3.3, for the error message.
std::string version_at_hand(const Egl& egl, EGLDisplay display) {
  for (const int minor : {2, 1, 0}) {
    const EglResources made = create(egl, display, false, 3, minor);
    if (made.context == EGL_NO_CONTEXT) continue;
    const std::string version = version_by(bind(egl, made) ? egl.proc("glGetString") : nullptr);
    destroy(egl, made);
    return version;
  }
  return fmt::format("none (error {:#x})", egl.error());
}

// Makes a context with EGL on Mesa's surfaceless platform: the graphics card if there is one, else software. OpenGL 3.3
// core, or with `es` OpenGL ES 3.0, which is what a browser offers.
base::Result<OffscreenContext> make_egl_context(bool es) {
  const auto loaded = load_egl();
  if (!loaded) return loaded.status();
  const Egl egl = *loaded;
  const EGLDisplay display = open_display(egl);
  if (display == EGL_NO_DISPLAY)
    return base::Status{base::Code::graphics, "EGL has no display of Mesa's surfaceless platform"};
  const EglResources made = create_best(egl, display, es);
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

using Context = struct osmesa_context*;
constexpr int kRgba = 0x1908, kUnsignedByte = 0x1401;  // GL_RGBA, ...

constexpr int kFormat = 0x22, kDepthBits = 0x30, kStencilBits = 0x31, kProfile = 0x33, kCoreProfile = 0x34,
              kMajorVersion = 0x36, kMinorVersion = 0x37;  // OSMESA_FORMAT, ...

struct OsMesa {
  Context (*create)(const int* attributes, Context shared) = nullptr;
  void (*destroy)(Context) = nullptr;
  unsigned char (*make_current)(Context, void* buffer, unsigned type, int width, int height) = nullptr;
  void (*(*proc)(const char* name))() = nullptr;
};

base::Result<OsMesa> load_osmesa() {
  const base::Result<void*> loaded = load_first({"libOSMesa.so.8", "libOSMesa.so.6", "libOSMesa.so"});
  if (!loaded) return loaded.status();
  void* const library = *loaded;
  OsMesa mesa;
  if (!look_up(library, "OSMesaCreateContextAttribs", mesa.create) ||
      !look_up(library, "OSMesaDestroyContext", mesa.destroy) ||
      !look_up(library, "OSMesaMakeCurrent", mesa.make_current) || !look_up(library, "OSMesaGetProcAddress", mesa.proc))
    return base::Status{base::Code::graphics, "libOSMesa is too old: OSMesaCreateContextAttribs is missing"};
  return mesa;
}

// OSMesa needs a colour buffer; as small as possible.
struct Buffer {
  static constexpr int kSide = 16;
  std::array<unsigned char, std::size_t{4} * kSide * kSide> bytes{};
};

bool bind(const OsMesa& mesa, Context context, Buffer& buffer) {
  return mesa.make_current(context, buffer.bytes.data(), kUnsignedByte, Buffer::kSide, Buffer::kSide) != 0;
}

Context create_core(const OsMesa& mesa, int major, int minor) {
  const int attributes[] = {kFormat,  kRgba,        kDepthBits,    24,    kStencilBits,  8,
                            kProfile, kCoreProfile, kMajorVersion, major, kMinorVersion, minor,
                            0};
  return mesa.create(attributes, nullptr);
}

void destroy(const OsMesa& mesa, Context context) {
  mesa.make_current(nullptr, nullptr, 0, 0, 0);
  mesa.destroy(context);
}

// Returns the version of a driver that rejected 3.3, for the error message.
std::string version_at_hand(const OsMesa& mesa) {
  const Context context = create_core(mesa, 3, 1);
  if (!context) return "none with a core profile";
  Buffer buffer;
  const std::string version = version_by(bind(mesa, context, buffer) ? mesa.proc("glGetString") : nullptr);
  destroy(mesa, context);
  return version;
}

// Makes a context with Mesa's OSMesa, OpenGL 3.3 core: software only. Mesa dropped it in version 25.1.
base::Result<OffscreenContext> make_osmesa_context() {
  const auto loaded = load_osmesa();
  if (!loaded) return loaded.status();
  const OsMesa mesa = *loaded;
  const Context context = create_core(mesa, 3, 3);
  if (!context) return base::Status{base::Code::graphics, "OpenGL 3.3 is needed, OSMesa has " + version_at_hand(mesa)};
  const auto buffer = std::make_shared<Buffer>();
  if (!bind(mesa, context, *buffer)) {
    mesa.destroy(context);
    return base::Status{base::Code::graphics, "OSMesa could not make its context current"};
  }
  return OffscreenContext{[mesa](const char* name) { return reinterpret_cast<void*>(mesa.proc(name)); },
                          [mesa, context, buffer] { destroy(mesa, context); }};
}

class OffscreenSurface final : public Surface {
 public:
  OffscreenSurface(OffscreenContext context, std::string library, Size size)
      : context_(std::move(context)), library_(std::move(library)), size_(size) {}
  ~OffscreenSurface() override { context_.destroy(); }

  void poll(Events& events, double) override {
    if (resized_) events.push_back(Resize{size_.width, size_.height});
    resized_ = false;
    events.push_back(Tick{1.0 / 60.0});
  }
  Size size() const override { return size_; }
  float content_scale() const override { return content_scale_; }
  void* gl_proc(const char* name) override { return context_.proc(name); }
  void present(unsigned) override {}
  double clock() const override {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
  }
  void set_title(const std::string&) override {}
  void resize(Size size) override {
    size_ = {std::max(size.width, 0), std::max(size.height, 0)};
    resized_ = true;
  }
  void set_content_scale(float scale) override { content_scale_ = scale; }
  std::string clipboard() override { return clipboard_; }
  void set_clipboard(const std::string& text) override { clipboard_ = text; }
  bool is_window() const override { return false; }
  std::string library() const override { return library_; }

 private:
  OffscreenContext context_;
  std::string library_;
  Size size_;
  float content_scale_ = 1;
  bool resized_ = false;
  std::string clipboard_;
};

struct OffscreenLibrary {
  std::string_view choice, name;
  base::Result<OffscreenContext> (*make)();
  bool by_name_alone = false;
};
constexpr OffscreenLibrary kLibraries[] = {{"osmesa", "OSMesa", make_osmesa_context},
                                           {"egl", "EGL", [] { return make_egl_context(false); }},
                                           {"gles", "EGL", [] { return make_egl_context(true); }, true}};

}  // namespace

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
base::Result<std::unique_ptr<Surface>> make_offscreen(const SurfaceOptions& options) {
  // Mesa's software renderer optimises its shaders for longer than most off-screen runs take to draw. Its first context
  // reads this once.
  setenv("GALLIVM_PERF", "nopt", 0);
  spare_driver_threads();
  const char* const named = std::getenv("COASTER_HEADLESS");
  const std::string wanted = options.headless.empty() && named ? named : options.headless;
  std::string reasons;
  for (const OffscreenLibrary& library : kLibraries) {
    if (wanted.empty() ? library.by_name_alone : library.choice != wanted) continue;
    auto context = library.make();
    if (context)
      return std::unique_ptr<Surface>(
          std::make_unique<OffscreenSurface>(std::move(*context), std::string(library.name), options.size));
    reasons += fmt::format("{}{}", reasons.empty() ? "" : "; ", context.status().message);
  }
  if (reasons.empty())
    return base::Status{base::Code::usage,
                        fmt::format("COASTER_HEADLESS: expected osmesa, egl or gles, found {}", wanted)};
  return base::Status{
      base::Code::graphics,
      fmt::format("No OpenGL without a display: {}. Install EGL (libegl1 and libgl1-mesa-dri on Debian)", reasons)};
}

}  // namespace coaster::platform
