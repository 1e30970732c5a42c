// Owners of OpenGL objects, framebuffers with attachments, and programs. Everything here requires the context of its Gl
// to be current, destructors too.
#pragma once

#include <array>
#include <span>
#include <string_view>
#include <utility>

#include <glm/glm.hpp>

#include "gfx/gl.h"

namespace coaster::gfx {

// One GL name, deleted by the destructor. Move-only.
class GlObject {
 public:
  using Destroy = void (*)(const Gl&, GLuint);
  GlObject() = default;
  GlObject(const Gl& gl, GLuint id, Destroy destroy) : gl_(&gl), id_(id), destroy_(destroy) {}
  GlObject(GlObject&& other) noexcept { swap(other); }
  GlObject& operator=(GlObject&& other) noexcept {
    swap(other);
    return *this;
  }
  ~GlObject() {
    if (id_ != 0) destroy_(*gl_, id_);
  }
  GLuint id() const { return id_; }

 private:
  void swap(GlObject& other) {
    std::swap(gl_, other.gl_);
    std::swap(id_, other.id_);
    std::swap(destroy_, other.destroy_);
  }
  const Gl* gl_ = nullptr;
  GLuint id_ = 0;
  Destroy destroy_ = nullptr;
};

// Creates one name by a function like glGenBuffers, to be deleted by its opposite.
template <auto Generate, auto Delete>
GlObject generate(const Gl& gl) {
  GLuint id = 0;
  (gl.*Generate)(1, &id);
  return {gl, id, [](const Gl& g, GLuint name) { (g.*Delete)(1, &name); }};
}
inline GlObject make_buffer(const Gl& gl) { return generate<&Gl::GenBuffers, &Gl::DeleteBuffers>(gl); }
inline GlObject make_vertex_array(const Gl& gl) { return generate<&Gl::GenVertexArrays, &Gl::DeleteVertexArrays>(gl); }
inline GlObject make_framebuffer(const Gl& gl) { return generate<&Gl::GenFramebuffers, &Gl::DeleteFramebuffers>(gl); }
// Binds the new texture to the active unit and clamps it at its edges.
GlObject make_texture(const Gl& gl, GLint min_filter, GLint mag_filter);

// Colour and depth of one size. samples 0: single-sampled.
struct RenderTarget {
  GlObject framebuffer, colour, depth;
  int width = 0, height = 0, samples = 0;
};
// Code::graphics if the driver rejects the combination.
base::Result<RenderTarget> make_target(const Gl& gl, int width, int height, int samples);

// The uniforms of a program, set by name while the program is in use. Names that the compiler has optimised away are
// ignored. An empty program ignores everything.
struct ShaderProgram {
  GlObject object;
  const Gl* gl = nullptr;
  void use() const {
    if (gl) gl->UseProgram(object.id());
  }
  void set(const char* name, int value) const {
    if (gl) gl->Uniform1i(place(name), value);
  }
  void set(const char* name, float value) const {
    if (gl) gl->Uniform1f(place(name), value);
  }
  void set(const char* name, glm::vec2 value) const {
    if (gl) gl->Uniform2f(place(name), value.x, value.y);
  }
  void set(const char* name, glm::vec3 value) const {
    if (gl) gl->Uniform3fv(place(name), 1, &value[0]);
  }
  void set(const char* name, glm::vec4 value) const {
    if (gl) gl->Uniform4fv(place(name), 1, &value[0]);
  }
  void set(const char* name, std::span<const glm::vec4> values) const {
    if (gl) gl->Uniform4fv(place(name), GLsizei(values.size()), &values[0][0]);
  }
  void set(const char* name, const glm::mat4& value) const {
    if (gl) gl->UniformMatrix4fv(place(name), 1, GL_FALSE, &value[0][0]);
  }

 private:
  GLint place(const char* name) const { return gl->GetUniformLocation(object.id(), name); }
};

// A program's stages; empty ones are left out. `captured` are the outputs that transform feedback writes, interleaved.
struct ProgramSources {
  std::string_view name, common, vertex, tessellation_control, tessellation_evaluation, geometry, fragment;
  std::span<const char* const> captured;
};

// Returns the version line of every shader, in OpenGL ES with precisions: the sources need no other difference.
std::string_view shader_header(bool es, bool tessellation);

// Compiles and links. Prepends shader_header() to each stage, then `common` (shared functions). On failure
// Code::graphics with `name` and the compiler's log; line numbers count within each part.
base::Result<ShaderProgram> make_program(const Gl& gl, const ProgramSources& sources);

// Turns blending by alpha on or off; the result stays opaque over an opaque picture.
void blend(const Gl& gl, bool on);

// Sets a float attribute of the bound vertex array from the bound buffer; divisor 1: one value per instance.
void float_attribute(const Gl& gl, GLuint location, int components, std::size_t stride, std::size_t offset,
                     GLuint divisor = 0);

// GPU time of a part of a frame, by timer queries. Results arrive some frames later; nothing waits.
class GpuTimer {
 public:
  explicit GpuTimer(const Gl& gl);
  // Call around the part, once per frame, not nested. Does nothing if the driver has no timers or all are in use.
  void begin();
  void end();
  // ms of the newest finished part; 0: none yet.
  double ms() const { return ms_; }

 private:
  const Gl* gl_;
  std::array<GlObject, 4> ring_;        // queries; none without timers
  std::size_t started_ = 0, read_ = 0;  // parts so far
  bool measuring_ = false;
  double ms_ = 0;
};

}  // namespace coaster::gfx
