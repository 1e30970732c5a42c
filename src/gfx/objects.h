// Owners of OpenGL objects, framebuffers with attachments, and programs. Everything here requires the context of its Gl
// to be current, destructors too.
#pragma once

#include <initializer_list>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include <glm/glm.hpp>

#include "gfx/gl.h"

namespace coaster::gfx {

// One GL name, deleted by the destructor. Move-only.
class Object {
 public:
  using Destroy = void (*)(const Gl&, GLuint);
  Object() = default;
  Object(const Gl& gl, GLuint id, Destroy destroy) : gl_(&gl), id_(id), destroy_(destroy) {}
  Object(Object&& other) noexcept { swap(other); }
  Object& operator=(Object&& other) noexcept {
    swap(other);
    return *this;
  }
  ~Object() {
    if (id_ != 0) destroy_(*gl_, id_);
  }
  GLuint id() const { return id_; }

 private:
  void swap(Object& other) {
    std::swap(gl_, other.gl_);
    std::swap(id_, other.id_);
    std::swap(destroy_, other.destroy_);
  }
  const Gl* gl_ = nullptr;
  GLuint id_ = 0;
  Destroy destroy_ = nullptr;
};

Object make_buffer(const Gl& gl);
Object make_vertex_array(const Gl& gl);

// Colour and depth of one size. samples 0: single-sampled.
struct Target {
  Object framebuffer, colour, depth;
  int width = 0, height = 0, samples = 0;
};
// Code::graphics if the driver rejects the combination.
base::Result<Target> make_target(const Gl& gl, int width, int height, int samples);

// The uniforms of a program, set by name while the program is in use. Names that the compiler has optimised away are
// ignored.
struct Program {
  Object object;
  const Gl* gl = nullptr;
  void use() const { gl->UseProgram(object.id()); }
  void set(const char* name, int value) const;
  void set(const char* name, float value) const;
  void set(const char* name, glm::vec2 value) const;
  void set(const char* name, glm::vec3 value) const;
  void set(const char* name, glm::vec4 value) const;
  void set(const char* name, const glm::mat4& value) const;
};

// A program's stages; empty ones are left out. `captured` are the outputs that transform feedback writes, interleaved.
struct ProgramSources {
  std::string_view name, common, vertex, tessellation_control, tessellation_evaluation, geometry, fragment;
  std::span<const char* const> captured;
};

// Compiles and links. Prepends a version line to each stage (4.00 with tessellation, else 3.30), then `common` (shared
// functions). On failure Code::graphics with `name` and the compiler's log; line numbers count within each part.
base::Result<Program> make_program(const Gl& gl, const ProgramSources& sources);
base::Result<Program> make_program(const Gl& gl, std::string_view name, std::string_view common,
                                   std::string_view vertex, std::string_view fragment);

// Sets a float attribute of the bound vertex array from the bound buffer; divisor 1: one value per instance.
void float_attribute(const Gl& gl, GLuint location, int components, std::size_t stride, std::size_t offset,
                     GLuint divisor = 0);

}  // namespace coaster::gfx
