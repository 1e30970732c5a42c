// Fills the table of OpenGL functions and checks the version of the current context.
#include "gfx/gl.h"

#include <fmt/format.h>

#include "base/text.h"

namespace coaster::gfx {
namespace {

std::string text_of(const Gl& gl, GLenum name) {
  const GLubyte* text = gl.GetString(name);
  return text == nullptr ? std::string("unknown") : std::string(reinterpret_cast<const char*>(text));
}

// True if "4.50 - Build 1" is at least 3.30.
bool shaders_at_least_330(std::string_view version) {
  const std::size_t point = version.find('.');
  const auto major = base::parse_int(version.substr(0, point));
  const auto minor =
      point == std::string_view::npos
          ? std::nullopt
          : base::parse_int(version.substr(point + 1, version.find_first_not_of("0123456789", point + 1) - point - 1));
  return major && minor && (*major > 3 || (*major == 3 && *minor >= 30));
}

}  // namespace

std::string version_text(const Gl& gl) { return fmt::format("OpenGL {}{}.{}", gl.es ? "ES " : "", gl.major, gl.minor); }

base::Result<Gl> load_gl(const std::function<void*(const char*)>& proc) {
  Gl gl;
  const char* missing = nullptr;
  // Drivers return stubs for unknown names, so a non-null pointer proves little; a null pointer is certainly an error.
#define X(name)                                                    \
  gl.name = reinterpret_cast<decltype(gl.name)>(proc("gl" #name)); \
  if (gl.name == nullptr && missing == nullptr) missing = "gl" #name;
  COASTER_GL_FUNCTIONS(X)
#undef X
  if (gl.GetString == nullptr || gl.GetIntegerv == nullptr)
    return base::Status{base::Code::graphics, "OpenGL: no current context"};
  gl.version = text_of(gl, GL_VERSION);
  gl.es = gl.version.starts_with("OpenGL ES ");
  gl.GetIntegerv(GL_MAJOR_VERSION, &gl.major);
  gl.GetIntegerv(GL_MINOR_VERSION, &gl.minor);
  if (!gl.at_least(3, gl.es ? 0 : 3))
    return base::Status{base::Code::graphics,
                        fmt::format("OpenGL 3.3 or OpenGL ES 3.0 is needed, the driver has {}", gl.version)};
  if (const std::string shaders = text_of(gl, GL_SHADING_LANGUAGE_VERSION); !gl.es && !shaders_at_least_330(shaders))
    return base::Status{base::Code::graphics,
                        fmt::format("GLSL 3.30 is needed, the driver has {} (OpenGL {})", shaders, gl.version)};
  if (missing != nullptr)
    return base::Status{base::Code::graphics, fmt::format("OpenGL: the driver lacks {} ({})", missing, gl.version)};
#define X(name) \
  if (!gl.es) gl.name = reinterpret_cast<decltype(gl.name)>(proc("gl" #name));
  COASTER_GL_OPTIONAL_FUNCTIONS(X)
#undef X
  gl.GetIntegerv(GL_MAX_SAMPLES, &gl.max_samples);
  gl.renderer = text_of(gl, GL_RENDERER);
  return gl;
}

}  // namespace coaster::gfx
