// The OpenGL functions that the program uses, in a table, over the typedefs of the Khronos header.
#pragma once

#include <GL/glcorearb.h>

#include <functional>
#include <string>

#include "base/status.h"

// X(TYPE, Name): glName with type PFNGLTYPEPROC.
// clang-format off
#define COASTER_GL_FUNCTIONS(X) \
  X(ACTIVETEXTURE, ActiveTexture) X(ATTACHSHADER, AttachShader) X(BINDBUFFER, BindBuffer) \
  X(BINDBUFFERBASE, BindBufferBase) X(BINDFRAMEBUFFER, BindFramebuffer) X(BINDRENDERBUFFER, BindRenderbuffer) \
  X(BINDTEXTURE, BindTexture) X(BINDVERTEXARRAY, BindVertexArray) X(BLENDEQUATION, BlendEquation) \
  X(BLENDFUNC, BlendFunc) X(BLENDFUNCSEPARATE, BlendFuncSeparate) X(BLITFRAMEBUFFER, BlitFramebuffer) \
  X(BUFFERDATA, BufferData) X(BUFFERSUBDATA, BufferSubData) X(CHECKFRAMEBUFFERSTATUS, CheckFramebufferStatus) \
  X(CLEAR, Clear) X(CLEARCOLOR, ClearColor) X(COLORMASK, ColorMask) X(COMPILESHADER, CompileShader) \
  X(COPYBUFFERSUBDATA, CopyBufferSubData) X(CREATEPROGRAM, CreateProgram) X(CREATESHADER, CreateShader) \
  X(CULLFACE, CullFace) X(DELETEBUFFERS, DeleteBuffers) X(DELETEFRAMEBUFFERS, DeleteFramebuffers) \
  X(DELETEPROGRAM, DeleteProgram) X(DELETERENDERBUFFERS, DeleteRenderbuffers) X(DELETESHADER, DeleteShader) \
  X(DELETETEXTURES, DeleteTextures) X(DELETEVERTEXARRAYS, DeleteVertexArrays) X(DEPTHFUNC, DepthFunc) \
  X(DEPTHMASK, DepthMask) X(DISABLE, Disable) X(DISABLEVERTEXATTRIBARRAY, DisableVertexAttribArray) \
  X(DRAWARRAYS, DrawArrays) X(DRAWARRAYSINSTANCED, DrawArraysInstanced) X(DRAWBUFFER, DrawBuffer) \
  X(DRAWBUFFERS, DrawBuffers) X(DRAWELEMENTS, DrawElements) X(DRAWELEMENTSBASEVERTEX, DrawElementsBaseVertex) \
  X(DRAWELEMENTSINSTANCED, DrawElementsInstanced) X(ENABLE, Enable) \
  X(ENABLEVERTEXATTRIBARRAY, EnableVertexAttribArray) X(FINISH, Finish) \
  X(FRAMEBUFFERRENDERBUFFER, FramebufferRenderbuffer) X(FRAMEBUFFERTEXTURE2D, FramebufferTexture2D) \
  X(GENBUFFERS, GenBuffers) X(GENERATEMIPMAP, GenerateMipmap) X(GENFRAMEBUFFERS, GenFramebuffers) \
  X(GENRENDERBUFFERS, GenRenderbuffers) X(GENTEXTURES, GenTextures) X(GENVERTEXARRAYS, GenVertexArrays) \
  X(GETERROR, GetError) X(GETINTEGERV, GetIntegerv) X(GETPROGRAMINFOLOG, GetProgramInfoLog) \
  X(GETPROGRAMIV, GetProgramiv) X(GETSHADERINFOLOG, GetShaderInfoLog) X(GETSHADERIV, GetShaderiv) \
  X(GETSTRING, GetString) X(GETUNIFORMLOCATION, GetUniformLocation) X(LINKPROGRAM, LinkProgram) \
  X(MULTIDRAWARRAYS, MultiDrawArrays) X(MULTIDRAWELEMENTS, MultiDrawElements) X(PIXELSTOREI, PixelStorei) \
  X(POLYGONOFFSET, PolygonOffset) X(READBUFFER, ReadBuffer) X(READPIXELS, ReadPixels) \
  X(RENDERBUFFERSTORAGEMULTISAMPLE, RenderbufferStorageMultisample) X(SCISSOR, Scissor) \
  X(SHADERSOURCE, ShaderSource) X(TEXIMAGE2D, TexImage2D) X(TEXPARAMETERI, TexParameteri) \
  X(TEXPARAMETERFV, TexParameterfv) X(TEXSUBIMAGE2D, TexSubImage2D) X(UNIFORM1F, Uniform1f) X(UNIFORM1I, Uniform1i) \
  X(UNIFORM2F, Uniform2f) X(UNIFORM3FV, Uniform3fv) X(UNIFORM4FV, Uniform4fv) X(UNIFORMMATRIX3FV, UniformMatrix3fv) \
  X(UNIFORMMATRIX4FV, UniformMatrix4fv) X(USEPROGRAM, UseProgram) X(VERTEXATTRIB4F, VertexAttrib4f) \
  X(VERTEXATTRIBDIVISOR, VertexAttribDivisor) X(VERTEXATTRIBPOINTER, VertexAttribPointer) X(VIEWPORT, Viewport)

// Optional functions: measuring on the GPU, and the stages beyond the base path. Null if the driver lacks them. A
// non-null pointer does not prove support; the version does.
#define COASTER_GL_OPTIONAL_FUNCTIONS(X) \
  X(BEGINQUERY, BeginQuery) X(BEGINTRANSFORMFEEDBACK, BeginTransformFeedback) X(DELETEQUERIES, DeleteQueries) \
  X(ENDQUERY, EndQuery) X(ENDTRANSFORMFEEDBACK, EndTransformFeedback) X(GENQUERIES, GenQueries) \
  X(GETBUFFERSUBDATA, GetBufferSubData) X(GETQUERYOBJECTUI64V, GetQueryObjectui64v) \
  X(GETQUERYOBJECTUIV, GetQueryObjectuiv) X(PATCHPARAMETERI, PatchParameteri) \
  X(TRANSFORMFEEDBACKVARYINGS, TransformFeedbackVaryings)
// clang-format on

namespace coaster::gfx {

struct Gl {
#define X(type, name) PFNGL##type##PROC name = nullptr;
  COASTER_GL_FUNCTIONS(X)
  COASTER_GL_OPTIONAL_FUNCTIONS(X)
#undef X
  int major = 0, minor = 0;
  int max_samples = 0;
  std::string renderer;  // GL_RENDERER: "llvmpipe (LLVM 15.0.6, 256 bits)"
  std::string version;   // GL_VERSION: "4.5 (Core Profile) Mesa 22.3.6"

  bool at_least(int wanted_major, int wanted_minor) const {
    return major > wanted_major || (major == wanted_major && minor >= wanted_minor);
  }
};

// Looks up every function in the current context; optional ones may stay null. Code::graphics if the version is below
// 3.3 (the message has both versions).
base::Result<Gl> load_gl(const std::function<void*(const char*)>& proc);

}  // namespace coaster::gfx
