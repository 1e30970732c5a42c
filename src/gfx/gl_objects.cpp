// Creation of OpenGL objects.
#include "gfx/gl_objects.h"

#include <string>
#include <vector>

#include <fmt/format.h>

namespace coaster::gfx {
namespace {

std::string log_of(const Gl& gl, GLuint id, bool program) {
  GLint length = 0;
  (program ? gl.GetProgramiv : gl.GetShaderiv)(id, GL_INFO_LOG_LENGTH, &length);
  std::vector<char> text(static_cast<std::size_t>(length) + 1, '\0');
  (program ? gl.GetProgramInfoLog : gl.GetShaderInfoLog)(id, length + 1, nullptr, text.data());
  return text.data();
}

// A stage of a program; `extension`: of its file.
struct ShaderStage {
  GLenum kind;
  const char* extension;
  std::string_view source;
};

base::Result<GlObject> compile(const Gl& gl, std::string_view name, std::string_view header, std::string_view common,
                               const ShaderStage& stage) {
  GlObject shader(gl, gl.CreateShader(stage.kind), [](const Gl& g, GLuint id) { g.DeleteShader(id); });
  const std::string text = fmt::format("{}{}\n#line 1\n{}", header, common, stage.source);
  const char* const whole = text.c_str();
  gl.ShaderSource(shader.id(), 1, &whole, nullptr);
  gl.CompileShader(shader.id());
  GLint ok = GL_FALSE;
  gl.GetShaderiv(shader.id(), GL_COMPILE_STATUS, &ok);
  if (ok != GL_TRUE)
    return base::Status{base::Code::graphics,
                        fmt::format("shader {}.{}: {}", name, stage.extension, log_of(gl, shader.id(), false))};
  return shader;
}

GlObject make_renderbuffer(const Gl& gl, GLenum format, int width, int height, int samples) {
  GlObject made = generate<&Gl::GenRenderbuffers, &Gl::DeleteRenderbuffers>(gl);
  gl.BindRenderbuffer(GL_RENDERBUFFER, made.id());
  gl.RenderbufferStorageMultisample(GL_RENDERBUFFER, samples, format, width, height);
  return made;
}

}  // namespace

GlObject make_texture(const Gl& gl, GLint min_filter, GLint mag_filter) {
  GlObject made = generate<&Gl::GenTextures, &Gl::DeleteTextures>(gl);
  gl.BindTexture(GL_TEXTURE_2D, made.id());
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, min_filter);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, mag_filter);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  return made;
}

base::Result<RenderTarget> make_target(const Gl& gl, int width, int height, int samples) {
  RenderTarget target;
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

std::string_view shader_header(bool es, bool tessellation) {
  if (es)
    return "#version 300 es\nprecision highp float;\nprecision highp int;\nprecision highp sampler2D;\n"
           "precision highp sampler2DShadow;\n";
  return tessellation ? "#version 400 core\n" : "#version 330 core\n";
}

base::Result<ShaderProgram> make_program(const Gl& gl, const ProgramSources& sources) {
  const ShaderStage stages[] = {{GL_VERTEX_SHADER, "vert", sources.vertex},
                                {GL_TESS_CONTROL_SHADER, "tesc", sources.tessellation_control},
                                {GL_TESS_EVALUATION_SHADER, "tese", sources.tessellation_evaluation},
                                {GL_GEOMETRY_SHADER, "geom", sources.geometry},
                                {GL_FRAGMENT_SHADER, "frag", sources.fragment}};
  const std::string_view header = shader_header(gl.es, !sources.tessellation_evaluation.empty());
  ShaderProgram program{GlObject(gl, gl.CreateProgram(), [](const Gl& g, GLuint id) { g.DeleteProgram(id); }), &gl};
  const GLuint id = program.object.id();
  std::vector<GlObject> shaders;
  for (const ShaderStage& stage : stages) {
    if (stage.source.empty()) continue;
    auto shader = compile(gl, sources.name, header, sources.common, stage);
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

void blend(const Gl& gl, bool on) {
  (on ? gl.Enable : gl.Disable)(GL_BLEND);
  gl.BlendEquation(GL_FUNC_ADD);
  gl.BlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
}

void float_attribute(const Gl& gl, GLuint location, int components, std::size_t stride, std::size_t offset,
                     GLuint divisor) {
  gl.EnableVertexAttribArray(location);
  gl.VertexAttribPointer(location, components, GL_FLOAT, GL_FALSE, GLsizei(stride),
                         reinterpret_cast<const void*>(offset));
  gl.VertexAttribDivisor(location, divisor);
}

GpuTimer::GpuTimer(const Gl& gl) : gl_(&gl) {
  if (!gl.has_timers()) return;
  for (GlObject& query : ring_) query = generate<&Gl::GenQueries, &Gl::DeleteQueries>(gl);
}

void GpuTimer::begin() {
  for (; read_ < started_; ++read_) {
    const GLuint query = ring_[read_ % ring_.size()].id();
    GLuint there = GL_FALSE;
    gl_->GetQueryObjectuiv(query, GL_QUERY_RESULT_AVAILABLE, &there);
    if (there == GL_FALSE) break;
    GLuint64 nanoseconds = 0;
    gl_->GetQueryObjectui64v(query, GL_QUERY_RESULT, &nanoseconds);
    ms_ = static_cast<double>(nanoseconds) * 1e-6;
  }
  const GLuint next = ring_[started_ % ring_.size()].id();
  measuring_ = next != 0 && started_ - read_ < ring_.size();
  if (measuring_) gl_->BeginQuery(GL_TIME_ELAPSED, next);
}

void GpuTimer::end() {
  if (!measuring_) return;
  gl_->EndQuery(GL_TIME_ELAPSED);
  ++started_;
  measuring_ = false;
}

}  // namespace coaster::gfx
