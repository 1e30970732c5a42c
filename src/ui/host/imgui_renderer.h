// Draws Dear ImGui's draw lists with the program's GL table, the same on every surface. No gamma correction.
#pragma once

#include <imgui.h>

#include <cstdint>
#include <map>

#include "base/status.h"
#include "gfx/gl_objects.h"

namespace coaster::ui {

class ImGuiRenderer {
 public:
  // `gl` must outlive the renderer, and its context must be current in every call. Code::graphics with the compiler's
  // log on failure.
  static base::Result<ImGuiRenderer> make(const gfx::Gl& gl);
  // Draws into the bound framebuffer of that size. Leaves blending, scissor and depth test off and no program, array or
  // texture bound.
  void draw(const ImDrawData& data, int width, int height);

 private:
  ImGuiRenderer(const gfx::Gl& gl, gfx::ShaderProgram program);
  void update_textures();
  void draw_list(const ImDrawList& list, ImVec2 origin, int width, int height);

  const gfx::Gl* gl_;
  gfx::ShaderProgram program_;
  gfx::GlObject array_, vertices_, indices_;
  std::map<std::uintptr_t, gfx::GlObject> textures_;  // by texture id, from kOwnTexture on
};

}  // namespace coaster::ui
