// Draws Dear ImGui's draw lists with the program's GL table, the same on every surface. No gamma.
#pragma once

#include <memory>

#include <imgui.h>

#include "base/status.h"
#include "gfx/gl.h"

namespace coaster::ui {

class ImGuiRenderer {
 public:
  // `gl` must outlive it and its context be current in every call. Code::graphics with the compiler's log on failure.
  static base::Result<std::unique_ptr<ImGuiRenderer>> make(const gfx::Gl& gl);
  ~ImGuiRenderer();
  ImGuiRenderer(const ImGuiRenderer&) = delete;
  ImGuiRenderer& operator=(const ImGuiRenderer&) = delete;

  // Makes the font texture from the atlas of the current context.
  void upload_fonts();
  // Into the bound framebuffer of that size. Leaves blending, scissor and depth test off and no program, array or
  // texture bound.
  void draw(const ImDrawData& data, int width, int height);

 private:
  explicit ImGuiRenderer(const gfx::Gl& gl) : gl_(gl) {}
  void draw_list(const ImDrawList& list, ImVec2 origin, int width, int height);

  const gfx::Gl& gl_;
  GLuint program_ = 0, array_ = 0, vertices_ = 0, indices_ = 0, font_ = 0;
  GLint scale_ = -1, texture_ = -1;
};

}  // namespace coaster::ui
