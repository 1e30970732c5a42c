// Draws Dear ImGui's lists with the program's GL table.
#include "ui/host/imgui_renderer.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "ui/widgets/imgui_compat.h"

namespace coaster::ui {
namespace {

constexpr const char* kVertexShader = R"(layout(location = 0) in vec2 position;
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
constexpr const char* kFragmentShader = R"(in vec2 v_place;
in vec4 v_colour;
uniform sampler2D image;
out vec4 result;
void main() { result = v_colour * texture(image, v_place); }
)";

const void* offset(std::size_t bytes) { return reinterpret_cast<const void*>(bytes); }

// Sets the attributes so that index 0 is vertex `first` of the bound buffer: OpenGL ES 3.0 has no base vertex.
void vertices_from(const gfx::Gl& gl, std::size_t first) {
  const std::size_t at = first * sizeof(ImDrawVert);
  gl.VertexAttribPointer(0, 2, GL_FLOAT, GL_FALSE, sizeof(ImDrawVert), offset(at + offsetof(ImDrawVert, pos)));
  gl.VertexAttribPointer(1, 2, GL_FLOAT, GL_FALSE, sizeof(ImDrawVert), offset(at + offsetof(ImDrawVert, uv)));
  gl.VertexAttribPointer(2, 4, GL_UNSIGNED_BYTE, GL_TRUE, sizeof(ImDrawVert), offset(at + offsetof(ImDrawVert, col)));
}

}  // namespace

base::Result<ImGuiRenderer> ImGuiRenderer::make(const gfx::Gl& gl) {
  auto program = gfx::make_program(gl, {.name = "panels", .vertex = kVertexShader, .fragment = kFragmentShader});
  if (!program) return program.status();
  return ImGuiRenderer(gl, std::move(*program));
}

ImGuiRenderer::ImGuiRenderer(const gfx::Gl& gl, gfx::ShaderProgram program)
    : gl_(&gl),
      program_(std::move(program)),
      array_(gfx::make_vertex_array(gl)),
      vertices_(gfx::make_buffer(gl)),
      indices_(gfx::make_buffer(gl)) {
  gl.BindVertexArray(array_.id());
  gl.BindBuffer(GL_ARRAY_BUFFER, vertices_.id());
  gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_.id());
  for (GLuint i = 0; i < 3; ++i) gl.EnableVertexAttribArray(i);
  gl.BindVertexArray(0);
}

void ImGuiRenderer::update_textures() {
  upload_textures([this](std::uintptr_t id, int width, int height, const void* pixels) {
    if (pixels == nullptr) {
      textures_.erase(id);
      return;
    }
    gfx::GlObject& texture = textures_[id];
    if (texture.id() == 0) texture = gfx::generate<&gfx::Gl::GenTextures, &gfx::Gl::DeleteTextures>(*gl_);
    gl_->BindTexture(GL_TEXTURE_2D, texture.id());
    gl_->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    gl_->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    gl_->PixelStorei(GL_UNPACK_ALIGNMENT, 4);
    gl_->TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE, pixels);
  });
}

void ImGuiRenderer::draw(const ImDrawData& data, int width, int height) {
  if (width < 1 || height < 1 || data.DisplaySize.x < 1 || data.DisplaySize.y < 1) return;
  gl_->Viewport(0, 0, width, height);
  gl_->Disable(GL_DEPTH_TEST);
  gl_->Disable(GL_CULL_FACE);
  gl_->Enable(GL_BLEND);
  gl_->Enable(GL_SCISSOR_TEST);
  gl_->BlendEquation(GL_FUNC_ADD);
  gl_->BlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  gl_->ActiveTexture(GL_TEXTURE0);
  update_textures();
  program_.use();
  program_.set("image", 0);
  program_.set("scale", glm::vec4(2.0f / data.DisplaySize.x, -2.0f / data.DisplaySize.y,
                                  -1.0f - data.DisplayPos.x * 2.0f / data.DisplaySize.x,
                                  1.0f + data.DisplayPos.y * 2.0f / data.DisplaySize.y));
  gl_->BindVertexArray(array_.id());
  for (const ImDrawList* const list : lists_of(data)) draw_list(*list, data.DisplayPos, width, height);
  gl_->BindVertexArray(0);
  gl_->BindTexture(GL_TEXTURE_2D, 0);
  gl_->UseProgram(0);
  gl_->Disable(GL_SCISSOR_TEST);
  gl_->Disable(GL_BLEND);
}

void ImGuiRenderer::draw_list(const ImDrawList& list, ImVec2 origin, int width, int height) {
  gl_->BindBuffer(GL_ARRAY_BUFFER, vertices_.id());
  gl_->BufferData(GL_ARRAY_BUFFER, list.VtxBuffer.Size * static_cast<GLsizeiptr>(sizeof(ImDrawVert)),
                  list.VtxBuffer.Data, GL_STREAM_DRAW);
  gl_->BufferData(GL_ELEMENT_ARRAY_BUFFER, list.IdxBuffer.Size * static_cast<GLsizeiptr>(sizeof(ImDrawIdx)),
                  list.IdxBuffer.Data, GL_STREAM_DRAW);
  unsigned first = 0;
  vertices_from(*gl_, first);
  for (const ImDrawCmd& command : list.CmdBuffer) {
    if (command.UserCallback != nullptr) continue;  // the program queues none
    const int left = std::max(0, static_cast<int>(command.ClipRect.x - origin.x));
    const int top = std::max(0, static_cast<int>(command.ClipRect.y - origin.y));
    const int right = std::min(width, static_cast<int>(command.ClipRect.z - origin.x));
    const int bottom = std::min(height, static_cast<int>(command.ClipRect.w - origin.y));
    if (right <= left || bottom <= top) continue;
    gl_->Scissor(left, height - bottom, right - left, bottom - top);
    const std::uintptr_t id = texture_of(command);
    const auto own = textures_.find(id);
    gl_->BindTexture(GL_TEXTURE_2D, own != textures_.end() ? own->second.id() : static_cast<GLuint>(id));
    if (command.VtxOffset != first) vertices_from(*gl_, first = command.VtxOffset);
    gl_->DrawElements(GL_TRIANGLES, static_cast<GLsizei>(command.ElemCount),
                      sizeof(ImDrawIdx) == 2 ? GL_UNSIGNED_SHORT : GL_UNSIGNED_INT,
                      offset(command.IdxOffset * sizeof(ImDrawIdx)));
  }
}

}  // namespace coaster::ui
