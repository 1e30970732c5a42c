// The OpenGL functions that the program uses, in a table, with the types of the Khronos header. All but a few belong
// to OpenGL ES 3.0, which is what WebGL 2 offers.
#pragma once

#define GL_GLEXT_PROTOTYPES  // for the types of the functions; none is linked
#include <GL/glcorearb.h>

#include <functional>
#include <string>

#include "base/status.h"

// X(Name): glName. Functions of OpenGL ES 3.0 and of OpenGL 3.3.
// clang-format off
#define COASTER_GL_FUNCTIONS(X) \
  X(ActiveTexture) X(AttachShader) X(BeginQuery) X(BeginTransformFeedback) X(BindBuffer) \
  X(BindBufferBase) X(BindFramebuffer) X(BindRenderbuffer) X(BindTexture) X(BindVertexArray) X(BlendEquation) \
  X(BlendFuncSeparate) X(BlitFramebuffer) X(BufferData) X(BufferSubData) X(CheckFramebufferStatus) X(Clear) \
  X(ClearColor) X(ColorMask) X(CompileShader) X(CopyBufferSubData) X(CreateProgram) X(CreateShader) X(CullFace) \
  X(DeleteBuffers) X(DeleteFramebuffers) X(DeleteProgram) X(DeleteQueries) X(DeleteRenderbuffers) X(DeleteShader) \
  X(DeleteTextures) X(DeleteVertexArrays) X(DepthFunc) X(DepthMask) X(Disable) X(DisableVertexAttribArray) \
  X(DrawArrays) X(DrawArraysInstanced) X(DrawElements) X(DrawElementsInstanced) X(Enable) \
  X(EnableVertexAttribArray) X(EndQuery) X(EndTransformFeedback) X(Finish) X(FramebufferRenderbuffer) \
  X(FramebufferTexture2D) X(GenBuffers) X(GenerateMipmap) X(GenFramebuffers) X(GenQueries) X(GenRenderbuffers) \
  X(GenTextures) X(GenVertexArrays) X(GetError) X(GetIntegerv) X(GetProgramInfoLog) X(GetProgramiv) \
  X(GetQueryObjectuiv) X(GetShaderInfoLog) X(GetShaderiv) X(GetString) X(GetUniformLocation) X(LinkProgram) \
  X(MapBufferRange) X(PixelStorei) X(ReadPixels) X(RenderbufferStorageMultisample) X(Scissor) X(ShaderSource) \
  X(TexImage2D) X(TexParameteri) X(TexSubImage2D) X(TransformFeedbackVaryings) X(Uniform1f) X(Uniform1i) \
  X(Uniform2f) X(Uniform3fv) X(Uniform4fv) X(UniformMatrix4fv) X(UnmapBuffer) X(UseProgram) X(VertexAttrib4f) \
  X(VertexAttribDivisor) X(VertexAttribPointer) X(Viewport)

// Functions outside OpenGL ES 3.0. Null on OpenGL ES, or if the driver lacks them: ask Gl::has_tessellation() and
// Gl::has_timers() before a call.
#define COASTER_GL_OPTIONAL_FUNCTIONS(X) X(GetQueryObjectui64v) X(PatchParameteri)
// clang-format on

namespace coaster::gfx {

struct Gl {
#define X(name) decltype(&gl##name) name = nullptr;
  COASTER_GL_FUNCTIONS(X)
  COASTER_GL_OPTIONAL_FUNCTIONS(X)
#undef X
  bool es = false;  // OpenGL ES, as in WebGL 2
  int major = 0, minor = 0;
  int max_samples = 0;
  std::string renderer;  // GL_RENDERER: "llvmpipe (LLVM 15.0.6, 256 bits)"
  std::string version;   // GL_VERSION: "4.5 (Core Profile) Mesa 22.3.6"

  bool at_least(int wanted_major, int wanted_minor) const {
    return major > wanted_major || (major == wanted_major && minor >= wanted_minor);
  }
  // What OpenGL ES 3.0 does not have.
  bool has_geometry_shaders() const { return !es; }
  bool has_tessellation() const { return !es && at_least(4, 0) && PatchParameteri != nullptr; }
  bool has_timers() const { return !es && GetQueryObjectui64v != nullptr; }  // GL_TIME_ELAPSED
};

// Returns "OpenGL 4.5" or "OpenGL ES 3.0".
std::string version_text(const Gl& gl);

// Looks up every function in the current context; optional ones may stay null. Code::graphics if the version is below
// OpenGL 3.3 or OpenGL ES 3.0 (the message has both versions).
base::Result<Gl> load_gl(const std::function<void*(const char*)>& proc);

}  // namespace coaster::gfx
