// Draws Dear ImGui's lists over our own GL table.
#include "ui/host/imgui_renderer.h"

#include <algorithm>
#include <cstdint>
#include <string>

namespace coaster::ui {
namespace {

constexpr const char* kVertexShader = R"(#version 330 core
layout(location = 0) in vec2 position;
layout(location = 1) in vec2 place;
layout(location = 2) in vec4 colour;
uniform vec4 scale;  // pixels to clip space: xy factor, zw offset
out vec2 v_place;
out vec4 v_colour;
void main() {
  v_place = place;
  v_colour = colour;
  gl_Position = vec4(position * scale.xy + scale.zw, 0.0, 1.0);
}
)";
constexpr const char* kFragmentShader = R"(#version 330 core
in vec2 v_place;
in vec4 v_colour;
uniform sampler2D image;
out vec4 result;
void main() { result = v_colour * texture(image, v_place); }
)";

GLuint compile(const gfx::Gl& gl, GLenum kind, const char* source, std::string& log) {
  const GLuint shader = gl.CreateShader(kind);
  gl.ShaderSource(shader, 1, &source, nullptr);
  gl.CompileShader(shader);
  GLint ok = 0;
  gl.GetShaderiv(shader, GL_COMPILE_STATUS, &ok);
  if (ok == GL_TRUE) return shader;
  char text[1024] = "";
  gl.GetShaderInfoLog(shader, sizeof text, nullptr, text);
  log += text;
  gl.DeleteShader(shader);
  return 0;
}

GLuint link(const gfx::Gl& gl, std::string& log) {
  const GLuint vertex = compile(gl, GL_VERTEX_SHADER, kVertexShader, log);
  const GLuint fragment = compile(gl, GL_FRAGMENT_SHADER, kFragmentShader, log);
  GLuint program = 0;
  if (vertex != 0 && fragment != 0) {
    program = gl.CreateProgram();
    gl.AttachShader(program, vertex);
    gl.AttachShader(program, fragment);
    gl.LinkProgram(program);
    GLint ok = 0;
    gl.GetProgramiv(program, GL_LINK_STATUS, &ok);
    if (ok != GL_TRUE) {
      char text[1024] = "";
      gl.GetProgramInfoLog(program, sizeof text, nullptr, text);
      log += text;
      gl.DeleteProgram(program);
      program = 0;
    }
  }
  gl.DeleteShader(vertex);
  gl.DeleteShader(fragment);
  return program;
}

const void* offset(std::size_t bytes) { return reinterpret_cast<const void*>(bytes); }

}  // namespace

base::Result<std::unique_ptr<ImGuiRenderer>> ImGuiRenderer::make(const gfx::Gl& gl) {
  std::unique_ptr<ImGuiRenderer> r(new ImGuiRenderer(gl));
  std::string log;
  r->program_ = link(gl, log);
  if (r->program_ == 0) return base::Status{base::Code::graphics, "the panels' shaders do not compile: " + log};
  r->scale_ = gl.GetUniformLocation(r->program_, "scale");
  r->texture_ = gl.GetUniformLocation(r->program_, "image");
  gl.GenVertexArrays(1, &r->array_);
  gl.GenBuffers(1, &r->vertices_);
  gl.GenBuffers(1, &r->indices_);
  gl.BindVertexArray(r->array_);
  gl.BindBuffer(GL_ARRAY_BUFFER, r->vertices_);
  gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, r->indices_);
  for (GLuint i = 0; i < 3; ++i) gl.EnableVertexAttribArray(i);
  gl.VertexAttribPointer(0, 2, GL_FLOAT, GL_FALSE, sizeof(ImDrawVert), offset(IM_OFFSETOF(ImDrawVert, pos)));
  gl.VertexAttribPointer(1, 2, GL_FLOAT, GL_FALSE, sizeof(ImDrawVert), offset(IM_OFFSETOF(ImDrawVert, uv)));
  gl.VertexAttribPointer(2, 4, GL_UNSIGNED_BYTE, GL_TRUE, sizeof(ImDrawVert), offset(IM_OFFSETOF(ImDrawVert, col)));
  gl.BindVertexArray(0);
  return r;
}

ImGuiRenderer::~ImGuiRenderer() {
  gl_.DeleteProgram(program_);
  gl_.DeleteVertexArrays(1, &array_);
  gl_.DeleteBuffers(1, &vertices_);
  gl_.DeleteBuffers(1, &indices_);
  gl_.DeleteTextures(1, &font_);
}

void ImGuiRenderer::upload_fonts() {
  ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
  unsigned char* pixels = nullptr;
  int width = 0, height = 0;
  atlas.GetTexDataAsRGBA32(&pixels, &width, &height);
  if (font_ == 0) gl_.GenTextures(1, &font_);
  gl_.BindTexture(GL_TEXTURE_2D, font_);
  gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  gl_.PixelStorei(GL_UNPACK_ALIGNMENT, 4);
  gl_.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE, pixels);
  gl_.BindTexture(GL_TEXTURE_2D, 0);
  atlas.SetTexID((ImTextureID)(std::uintptr_t)font_);  // a pointer in old versions, an integer in new ones
}

void ImGuiRenderer::draw(const ImDrawData& data, int width, int height) {
  if (width < 1 || height < 1 || data.DisplaySize.x < 1 || data.DisplaySize.y < 1) return;
  gl_.Viewport(0, 0, width, height);
  gl_.Disable(GL_DEPTH_TEST);
  gl_.Disable(GL_CULL_FACE);
  gl_.Enable(GL_BLEND);
  gl_.Enable(GL_SCISSOR_TEST);
  gl_.BlendEquation(GL_FUNC_ADD);
  gl_.BlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  gl_.UseProgram(program_);
  gl_.ActiveTexture(GL_TEXTURE0);
  gl_.Uniform1i(texture_, 0);
  const float scale[4] = {2.0f / data.DisplaySize.x, -2.0f / data.DisplaySize.y,
                          -1.0f - data.DisplayPos.x * 2.0f / data.DisplaySize.x,
                          1.0f + data.DisplayPos.y * 2.0f / data.DisplaySize.y};
  gl_.Uniform4fv(scale_, 1, scale);
  gl_.BindVertexArray(array_);
  for (int i = 0; i < data.CmdListsCount; ++i) draw_list(*data.CmdLists[i], data.DisplayPos, width, height);
  gl_.BindVertexArray(0);
  gl_.BindTexture(GL_TEXTURE_2D, 0);
  gl_.UseProgram(0);
  gl_.Disable(GL_SCISSOR_TEST);
  gl_.Disable(GL_BLEND);
}

void ImGuiRenderer::draw_list(const ImDrawList& list, ImVec2 origin, int width, int height) {
  gl_.BindBuffer(GL_ARRAY_BUFFER, vertices_);
  gl_.BufferData(GL_ARRAY_BUFFER, list.VtxBuffer.Size * static_cast<GLsizeiptr>(sizeof(ImDrawVert)),
                 list.VtxBuffer.Data, GL_STREAM_DRAW);
  gl_.BufferData(GL_ELEMENT_ARRAY_BUFFER, list.IdxBuffer.Size * static_cast<GLsizeiptr>(sizeof(ImDrawIdx)),
                 list.IdxBuffer.Data, GL_STREAM_DRAW);
  for (const ImDrawCmd& command : list.CmdBuffer) {
    if (command.UserCallback != nullptr) continue;  // we queue none
    const int left = std::max(0, static_cast<int>(command.ClipRect.x - origin.x));
    const int top = std::max(0, static_cast<int>(command.ClipRect.y - origin.y));
    const int right = std::min(width, static_cast<int>(command.ClipRect.z - origin.x));
    const int bottom = std::min(height, static_cast<int>(command.ClipRect.w - origin.y));
    if (right <= left || bottom <= top) continue;
    gl_.Scissor(left, height - bottom, right - left, bottom - top);
    gl_.BindTexture(GL_TEXTURE_2D, static_cast<GLuint>((std::uintptr_t)command.GetTexID()));
    gl_.DrawElements(GL_TRIANGLES, static_cast<GLsizei>(command.ElemCount),
                     sizeof(ImDrawIdx) == 2 ? GL_UNSIGNED_SHORT : GL_UNSIGNED_INT,
                     offset(command.IdxOffset * sizeof(ImDrawIdx)));
  }
}

}  // namespace coaster::ui
