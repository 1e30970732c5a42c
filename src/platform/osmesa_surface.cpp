// The off-screen surface: Mesa's OSMesa, loaded at run time so that the window needs no software renderer installed.
#include <GL/osmesa.h>
#include <dlfcn.h>

#include <algorithm>
#include <chrono>
#include <string>
#include <vector>

#include "platform/surface.h"

namespace coaster::platform {
namespace {

struct OsMesa {
  void* library = nullptr;
  decltype(&OSMesaCreateContextAttribs) create = nullptr;
  decltype(&OSMesaDestroyContext) destroy = nullptr;
  decltype(&OSMesaMakeCurrent) make_current = nullptr;
  decltype(&OSMesaGetProcAddress) proc = nullptr;
};

template <class F>
bool look_up(void* library, const char* name, F& function) {
  function = reinterpret_cast<F>(dlsym(library, name));
  return function != nullptr;
}

base::Result<OsMesa> load_library() {
  OsMesa mesa;
  for (const char* name : {"libOSMesa.so.8", "libOSMesa.so.6", "libOSMesa.so"})
    if (!mesa.library) mesa.library = dlopen(name, RTLD_NOW | RTLD_LOCAL);
  if (!mesa.library)
    return base::Status{base::Code::graphics,
                        "libOSMesa.so.8 was not found; install it with: apt-get install libosmesa6"};
  if (!look_up(mesa.library, "OSMesaCreateContextAttribs", mesa.create) ||
      !look_up(mesa.library, "OSMesaDestroyContext", mesa.destroy) ||
      !look_up(mesa.library, "OSMesaMakeCurrent", mesa.make_current) ||
      !look_up(mesa.library, "OSMesaGetProcAddress", mesa.proc))
    return base::Status{base::Code::graphics, "libOSMesa is too old: OSMesaCreateContextAttribs is missing"};
  return mesa;
}

class OffscreenSurface final : public Surface {
 public:
  OffscreenSurface(OsMesa mesa, OSMesaContext context, Size size) : mesa_(mesa), context_(context), size_(size) {}
  ~OffscreenSurface() override {
    mesa_.make_current(nullptr, nullptr, 0, 0, 0);
    mesa_.destroy(context_);
    // The library stays loaded, because its threads and atexit handlers need their code.
  }

  // OSMesa needs a colour buffer of its own; ours is as small as possible, because frames are in the renderer's
  // framebuffer.
  bool bind() { return mesa_.make_current(context_, buffer_.data(), GL_UNSIGNED_BYTE, kBuffer, kBuffer) == GL_TRUE; }

  void poll(Events& events) override {
    if (resized_) events.push_back(Resize{size_.width, size_.height});
    resized_ = false;
    events.push_back(Tick{1.0 / 60.0});
  }
  Size size() const override { return size_; }
  float content_scale() const override { return 1.0f; }
  void* gl_proc(const char* name) override { return reinterpret_cast<void*>(mesa_.proc(name)); }
  void present(unsigned) override {}
  double clock() const override {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
  }
  void set_title(const std::string&) override {}
  void resize(Size size) override {
    size_ = {std::max(size.width, 0), std::max(size.height, 0)};
    resized_ = true;
  }
  std::string clipboard() override { return clipboard_; }
  void set_clipboard(const std::string& text) override { clipboard_ = text; }
  bool is_window() const override { return false; }
  std::optional<Placement> placement() const override { return std::nullopt; }
  void place(const Placement&) override {}

 private:
  static constexpr int kBuffer = 16;
  OsMesa mesa_;
  OSMesaContext context_;
  std::vector<unsigned char> buffer_ = std::vector<unsigned char>(kBuffer * kBuffer * 4);
  Size size_;
  bool resized_ = false;
  std::string clipboard_;
};

OSMesaContext create_core(const OsMesa& mesa, int major, int minor) {
  const int attributes[][2] = {{OSMESA_FORMAT, OSMESA_RGBA},
                               {OSMESA_DEPTH_BITS, 24},
                               {OSMESA_STENCIL_BITS, 8},
                               {OSMESA_PROFILE, OSMESA_CORE_PROFILE},
                               {OSMESA_CONTEXT_MAJOR_VERSION, major},
                               {OSMESA_CONTEXT_MINOR_VERSION, minor},
                               {0, 0}};
  return mesa.create(attributes[0], nullptr);
}

// Returns the version of a driver that rejected 3.3, for the error message.
std::string version_at_hand(const OsMesa& mesa) {
  const OSMesaContext context = create_core(mesa, 3, 1);
  if (!context) return "none with a core profile";
  std::string version = "an unknown version";
  unsigned char buffer[4 * 4 * 4];
  const auto get_string = reinterpret_cast<decltype(&glGetString)>(mesa.proc("glGetString"));
  if (get_string && mesa.make_current(context, buffer, GL_UNSIGNED_BYTE, 4, 4) == GL_TRUE)
    if (const GLubyte* text = get_string(GL_VERSION)) version = reinterpret_cast<const char*>(text);
  mesa.make_current(nullptr, nullptr, 0, 0, 0);
  mesa.destroy(context);
  return version;
}

}  // namespace

base::Result<std::unique_ptr<Surface>> make_offscreen(const SurfaceOptions& options) {
  auto mesa = load_library();
  if (!mesa) return mesa.status();
  OSMesaContext context = create_core(*mesa, 3, 3);
  if (!context) return base::Status{base::Code::graphics, "OpenGL 3.3 is needed, OSMesa has " + version_at_hand(*mesa)};
  auto surface = std::make_unique<OffscreenSurface>(*mesa, context, options.size);
  if (!surface->bind()) return base::Status{base::Code::graphics, "OSMesa could not make its context current"};
  return std::unique_ptr<Surface>(std::move(surface));
}

}  // namespace coaster::platform
