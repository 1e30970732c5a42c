#include "platform/web_gl.h"

#include <GL/glcorearb.h>
#include <emscripten.h>

#include <cstdlib>
#include <cstring>
#include <utility>

extern "C" void* emscripten_webgl_get_proc_address(const char* name);

namespace coaster::platform {
namespace {

// Transform feedback is read by mapping a buffer, which WebGL lacks, so this returns a copy of its bytes.
void* mapped = nullptr;
void* map_range(GLenum target, GLintptr offset, GLsizeiptr length, GLbitfield) {
  mapped = std::malloc(static_cast<std::size_t>(length));
  // clang-format off
  EM_ASM({ GLctx.getBufferSubData($0, $1, HEAPU8, $2, $3); }, target, offset, mapped, length);
  // clang-format on
  return mapped;
}
GLboolean unmap(GLenum) {
  std::free(std::exchange(mapped, nullptr));
  return GL_TRUE;
}

}  // namespace

void* web_gl_function(const char* name) {
  if (std::strcmp(name, "glMapBufferRange") == 0) return reinterpret_cast<void*>(&map_range);
  if (std::strcmp(name, "glUnmapBuffer") == 0) return reinterpret_cast<void*>(&unmap);
  return emscripten_webgl_get_proc_address(name);
}

}  // namespace coaster::platform
