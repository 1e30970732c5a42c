// Creation of OpenGL objects.
#include "gfx/objects.h"

#include <vector>

#include <fmt/format.h>

namespace coaster::gfx {
namespace {

constexpr std::string_view kHeader = "#version 330 core\n", kTessellationHeader = "#version 400 core\n";

std::string log_of(const Gl& gl, GLuint id, bool program) {
  GLint length = 0;
  (program ? gl.GetProgramiv : gl.GetShaderiv)(id, GL_INFO_LOG_LENGTH, &length);
  std::vector<char> text(static_cast<std::size_t>(length) + 1, '\0');
  (program ? gl.GetProgramInfoLog : gl.GetShaderInfoLog)(id, length + 1, nullptr, text.data());
  return text.data();
}

const char* extension_of(GLenum kind) {
  switch (kind) {
    case GL_VERTEX_SHADER: return ".vert: ";
    case GL_TESS_CONTROL_SHADER: return ".tesc: ";
    case GL_TESS_EVALUATION_SHADER: return ".tese: ";
    case GL_GEOMETRY_SHADER: return ".geom: ";
    default: return ".frag: ";
  }
}

base::Result<Object> compile(const Gl& gl, GLenum kind, std::string_view name, std::string_view header,
                             std::string_view common, std::string_view source) {
  Object shader(gl, gl.CreateShader(kind), [](const Gl& g, GLuint id) { g.DeleteShader(id); });
  const char* parts[] = {header.data(), common.data(), "\n#line 1\n", source.data()};
  const GLint sizes[] = {GLint(header.size()), GLint(common.size()), 9, GLint(source.size())};
  gl.ShaderSource(shader.id(), 4, parts, sizes);
  gl.CompileShader(shader.id());
  GLint ok = GL_FALSE;
  gl.GetShaderiv(shader.id(), GL_COMPILE_STATUS, &ok);
  if (ok != GL_TRUE)
    return base::Status{base::Code::graphics,
                        fmt::format("shader {}{}{}", name, extension_of(kind), log_of(gl, shader.id(), false))};
  return shader;
}

Object make_framebuffer(const Gl& gl) {
  GLuint id = 0;
  gl.GenFramebuffers(1, &id);
  return {gl, id, [](const Gl& g, GLuint name) { g.DeleteFramebuffers(1, &name); }};
}

Object make_renderbuffer(const Gl& gl, GLenum format, int width, int height, int samples) {
  GLuint id = 0;
  gl.GenRenderbuffers(1, &id);
  gl.BindRenderbuffer(GL_RENDERBUFFER, id);
  gl.RenderbufferStorageMultisample(GL_RENDERBUFFER, samples, format, width, height);
  return {gl, id, [](const Gl& g, GLuint name) { g.DeleteRenderbuffers(1, &name); }};
}

}  // namespace

Object make_buffer(const Gl& gl) {
  GLuint id = 0;
  gl.GenBuffers(1, &id);
  return {gl, id, [](const Gl& g, GLuint name) { g.DeleteBuffers(1, &name); }};
}

Object make_vertex_array(const Gl& gl) {
  GLuint id = 0;
  gl.GenVertexArrays(1, &id);
  return {gl, id, [](const Gl& g, GLuint name) { g.DeleteVertexArrays(1, &name); }};
}

base::Result<Target> make_target(const Gl& gl, int width, int height, int samples) {
  Target target;
  target.width = width, target.height = height, target.samples = samples;
  target.framebuffer = make_framebuffer(gl);
  target.colour = make_renderbuffer(gl, GL_RGBA8, width, height, samples);
  target.depth = make_renderbuffer(gl, GL_DEPTH_COMPONENT24, width, height, samples);
  gl.BindFramebuffer(GL_FRAMEBUFFER, target.framebuffer.id());
  gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, target.colour.id());
  gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, target.depth.id());
  if (gl.CheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
    return base::Status{base::Code::graphics,
                        fmt::format("OpenGL: no framebuffer of {}x{} with {} samples", width, height, samples)};
  return target;
}

void Program::set(const char* name, int value) const {
  gl->Uniform1i(gl->GetUniformLocation(object.id(), name), value);
}
void Program::set(const char* name, float value) const {
  gl->Uniform1f(gl->GetUniformLocation(object.id(), name), value);
}
void Program::set(const char* name, glm::vec2 value) const {
  gl->Uniform2f(gl->GetUniformLocation(object.id(), name), value.x, value.y);
}
void Program::set(const char* name, glm::vec3 value) const {
  gl->Uniform3fv(gl->GetUniformLocation(object.id(), name), 1, &value[0]);
}
void Program::set(const char* name, glm::vec4 value) const {
  gl->Uniform4fv(gl->GetUniformLocation(object.id(), name), 1, &value[0]);
}
void Program::set(const char* name, const glm::mat4& value) const {
  gl->UniformMatrix4fv(gl->GetUniformLocation(object.id(), name), 1, GL_FALSE, &value[0][0]);
}

base::Result<Program> make_program(const Gl& gl, const ProgramSources& sources) {
  const std::pair<GLenum, std::string_view> stages[] = {{GL_VERTEX_SHADER, sources.vertex},
                                                        {GL_TESS_CONTROL_SHADER, sources.tessellation_control},
                                                        {GL_TESS_EVALUATION_SHADER, sources.tessellation_evaluation},
                                                        {GL_GEOMETRY_SHADER, sources.geometry},
                                                        {GL_FRAGMENT_SHADER, sources.fragment}};
  const std::string_view header = sources.tessellation_evaluation.empty() ? kHeader : kTessellationHeader;
  Program program{Object(gl, gl.CreateProgram(), [](const Gl& g, GLuint id) { g.DeleteProgram(id); }), &gl};
  const GLuint id = program.object.id();
  std::vector<Object> shaders;
  for (const auto& [kind, source] : stages) {
    if (source.empty()) continue;
    auto shader = compile(gl, kind, sources.name, header, sources.common, source);
    if (!shader) return shader.status();
    gl.AttachShader(id, shader->id());
    shaders.push_back(std::move(*shader));
  }
  if (!sources.captured.empty())
    gl.TransformFeedbackVaryings(id, GLsizei(sources.captured.size()), sources.captured.data(), GL_INTERLEAVED_ATTRIBS);
  gl.LinkProgram(id);
  GLint ok = GL_FALSE;
  gl.GetProgramiv(id, GL_LINK_STATUS, &ok);
  if (ok != GL_TRUE)
    return base::Status{base::Code::graphics,
                        fmt::format("shader {} does not link: {}", sources.name, log_of(gl, id, true))};
  return program;
}

base::Result<Program> make_program(const Gl& gl, std::string_view name, std::string_view common,
                                   std::string_view vertex, std::string_view fragment) {
  return make_program(gl, {name, common, vertex, {}, {}, {}, fragment, {}});
}

void float_attribute(const Gl& gl, GLuint location, int components, std::size_t stride, std::size_t offset,
                     GLuint divisor) {
  gl.EnableVertexAttribArray(location);
  gl.VertexAttribPointer(location, components, GL_FLOAT, GL_FALSE, GLsizei(stride),
                         reinterpret_cast<const void*>(offset));
  gl.VertexAttribDivisor(location, divisor);
}

}  // namespace coaster::gfx
