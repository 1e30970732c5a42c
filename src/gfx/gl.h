// The OpenGL functions that the program uses, in a table, over the typedefs of the Khronos header. All but a few belong
// to OpenGL ES 3.0, which is what WebGL 2 offers.
#pragma once

#include <GL/glcorearb.h>

#include <functional>
#include <string>

#include "base/status.h"

// X(TYPE, Name): glName with type PFNGLTYPEPROC. Functions of OpenGL ES 3.0 and of OpenGL 3.3.
// clang-format off
#define COASTER_GL_FUNCTIONS(X) \
  X(ACTIVETEXTURE, ActiveTexture) X(ATTACHSHADER, AttachShader) X(BEGINQUERY, BeginQuery) \
  X(BEGINTRANSFORMFEEDBACK, BeginTransformFeedback) X(BINDBUFFER, BindBuffer) \
  X(BINDBUFFERBASE, BindBufferBase) X(BINDFRAMEBUFFER, BindFramebuffer) \
  X(BINDRENDERBUFFER, BindRenderbuffer) X(BINDTEXTURE, BindTexture) X(BINDVERTEXARRAY, BindVertexArray) \
  X(BLENDEQUATION, BlendEquation) X(BLENDFUNCSEPARATE, BlendFuncSeparate) \
  X(BLITFRAMEBUFFER, BlitFramebuffer) X(BUFFERDATA, BufferData) X(BUFFERSUBDATA, BufferSubData) \
  X(CHECKFRAMEBUFFERSTATUS, CheckFramebufferStatus) X(CLEAR, Clear) X(CLEARCOLOR, ClearColor) \
  X(COLORMASK, ColorMask) X(COMPILESHADER, CompileShader) X(COPYBUFFERSUBDATA, CopyBufferSubData) \
  X(CREATEPROGRAM, CreateProgram) X(CREATESHADER, CreateShader) X(CULLFACE, CullFace) \
  X(DELETEBUFFERS, DeleteBuffers) X(DELETEFRAMEBUFFERS, DeleteFramebuffers) X(DELETEPROGRAM, DeleteProgram) \
  X(DELETEQUERIES, DeleteQueries) X(DELETERENDERBUFFERS, DeleteRenderbuffers) X(DELETESHADER, DeleteShader) \
  X(DELETETEXTURES, DeleteTextures) X(DELETEVERTEXARRAYS, DeleteVertexArrays) X(DEPTHFUNC, DepthFunc) \
  X(DEPTHMASK, DepthMask) X(DISABLE, Disable) X(DISABLEVERTEXATTRIBARRAY, DisableVertexAttribArray) \
  X(DRAWARRAYS, DrawArrays) X(DRAWARRAYSINSTANCED, DrawArraysInstanced) X(DRAWELEMENTS, DrawElements) \
  X(DRAWELEMENTSINSTANCED, DrawElementsInstanced) X(ENABLE, Enable) \
  X(ENABLEVERTEXATTRIBARRAY, EnableVertexAttribArray) X(ENDQUERY, EndQuery) \
  X(ENDTRANSFORMFEEDBACK, EndTransformFeedback) X(FINISH, Finish) \
  X(FRAMEBUFFERRENDERBUFFER, FramebufferRenderbuffer) X(FRAMEBUFFERTEXTURE2D, FramebufferTexture2D) \
  X(GENBUFFERS, GenBuffers) X(GENERATEMIPMAP, GenerateMipmap) X(GENFRAMEBUFFERS, GenFramebuffers) \
  X(GENQUERIES, GenQueries) X(GENRENDERBUFFERS, GenRenderbuffers) X(GENTEXTURES, GenTextures) \
  X(GENVERTEXARRAYS, GenVertexArrays) X(GETERROR, GetError) X(GETINTEGERV, GetIntegerv) \
  X(GETPROGRAMINFOLOG, GetProgramInfoLog) X(GETPROGRAMIV, GetProgramiv) \
  X(GETQUERYOBJECTUIV, GetQueryObjectuiv) X(GETSHADERINFOLOG, GetShaderInfoLog) X(GETSHADERIV, GetShaderiv) \
  X(GETSTRING, GetString) X(GETUNIFORMLOCATION, GetUniformLocation) X(LINKPROGRAM, LinkProgram) \
  X(MAPBUFFERRANGE, MapBufferRange) X(PIXELSTOREI, PixelStorei) \
  X(READPIXELS, ReadPixels) \
  X(RENDERBUFFERSTORAGEMULTISAMPLE, RenderbufferStorageMultisample) X(SCISSOR, Scissor) \
  X(SHADERSOURCE, ShaderSource) X(TEXIMAGE2D, TexImage2D) \
  X(TEXPARAMETERI, TexParameteri) X(TEXSUBIMAGE2D, TexSubImage2D) \
  X(TRANSFORMFEEDBACKVARYINGS, TransformFeedbackVaryings) X(UNIFORM1F, Uniform1f) X(UNIFORM1I, Uniform1i) \
  X(UNIFORM2F, Uniform2f) X(UNIFORM3FV, Uniform3fv) X(UNIFORM4FV, Uniform4fv) \
  X(UNIFORMMATRIX4FV, UniformMatrix4fv) X(UNMAPBUFFER, UnmapBuffer) \
  X(USEPROGRAM, UseProgram) X(VERTEXATTRIB4F, VertexAttrib4f) X(VERTEXATTRIBDIVISOR, VertexAttribDivisor) \
  X(VERTEXATTRIBPOINTER, VertexAttribPointer) X(VIEWPORT, Viewport)

// Functions outside OpenGL ES 3.0. Null on OpenGL ES, or if the driver lacks them: ask Gl::has_tessellation() and
// Gl::has_timers() before a call.
#define COASTER_GL_OPTIONAL_FUNCTIONS(X) \
  X(GETQUERYOBJECTUI64V, GetQueryObjectui64v) X(PATCHPARAMETERI, PatchParameteri)
// clang-format on

namespace coaster::gfx {

struct Gl {
#define X(type, name) PFNGL##type##PROC name = nullptr;
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
