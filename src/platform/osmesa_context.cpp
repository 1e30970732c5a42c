// OSMesa's functions are declared here instead of included: distributions drop the header with the library.
#include <array>
#include <memory>
#include <string>

#include "platform/offscreen_context.h"

namespace coaster::platform {
namespace {

using Context = struct osmesa_context*;
constexpr int kRgba = 0x1908, kUnsignedByte = 0x1401, kGlVersion = 0x1f02;  // GL_RGBA, ...
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
  std::string version = "an unknown version";
  Buffer buffer;
  const auto get_string = reinterpret_cast<const unsigned char* (*)(unsigned)>(mesa.proc("glGetString"));
  if (get_string && bind(mesa, context, buffer))
    if (const unsigned char* text = get_string(kGlVersion)) version = reinterpret_cast<const char*>(text);
  destroy(mesa, context);
  return version;
}

}  // namespace

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

}  // namespace coaster::platform
