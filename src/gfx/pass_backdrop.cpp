// Ground and sky, on their sides of the horizon, by shaders that follow the ray of each pixel.
#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "gfx/passes.h"
#include "gfx/sun_shadows.h"

namespace coaster::gfx {
namespace {

// A convex part of the viewport, -1 to 1, with as many corners as the shader takes.
struct Part {
  std::array<glm::vec2, 6> corners{};
  int count = 0;
};

// The part where a + b x + c y is not negative.
Part part_of_viewport(float a, float b, float c) {
  constexpr glm::vec2 kCorners[] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
  const auto height = [&](glm::vec2 at) { return a + b * at.x + c * at.y; };
  Part part;
  for (int i = 0; i < 4; ++i) {
    const glm::vec2 from = kCorners[i], to = kCorners[(i + 1) % 4];
    const float before = height(from), after = height(to);
    if (before >= 0) part.corners[static_cast<std::size_t>(part.count++)] = from;
    if ((before >= 0) != (after >= 0))
      part.corners[static_cast<std::size_t>(part.count++)] = glm::mix(from, to, before / (before - after));
  }
  return part;
}

struct Rays {
  glm::vec3 forward, right, up;  // right and up: to the viewport's edges at distance 1
};

void draw_part(const Pass& pass, const Program& program, const Rays& rays, const Part& part) {
  program.set("forward", rays.forward);
  program.set("right", rays.right);
  program.set("up", rays.up);
  program.set("eye", pass.scene.view.eye);
  for (std::size_t i = 0; i < part.corners.size(); ++i)
    program.set(fmt::format("corners[{}]", i).c_str(), part.corners[i]);
  if (!pass.scene.unseen) pass.gl.DrawArrays(GL_TRIANGLE_FAN, 0, part.count);
  pass.count(part.count - 2);
}

// Two draws: the sunlit ground, which writes depth 0.5 where a shadow may be; then the shadows, only there. So
// unshadowed pixels cost little.
void draw_ground(const Pass& pass, const SunShadows& shadows, const Rays& rays, const Part& part) {
  const Gl& gl = pass.gl;
  pass.programs.ground.use();
  shadows.bind(pass.programs.ground);
  gl.Enable(GL_DEPTH_TEST);
  gl.DepthFunc(GL_ALWAYS);
  draw_part(pass, pass.programs.ground, rays, part);
  if (!pass.scene.shadows) {
    gl.Clear(GL_DEPTH_BUFFER_BIT);
    return;
  }
  pass.programs.ground_shadow.use();
  shadows.bind(pass.programs.ground_shadow);
  gl.DepthFunc(GL_EQUAL);
  gl.DepthMask(GL_FALSE);
  gl.Enable(GL_BLEND);
  gl.BlendEquation(GL_FUNC_ADD);
  gl.BlendFuncSeparate(GL_DST_COLOR, GL_ZERO, GL_ZERO, GL_ONE);
  draw_part(pass, pass.programs.ground_shadow, rays, part);
  gl.DepthMask(GL_TRUE);
  gl.Clear(GL_DEPTH_BUFFER_BIT);
}

}  // namespace

void draw_backdrop(const Pass& pass, const SunShadows& shadows) {
  const view::View& view = pass.scene.view;
  // Rows of the view matrix are the camera's axes in the world; the projection is symmetric.
  const glm::mat3 axes = glm::transpose(glm::mat3(view.view));
  const Rays rays{-axes[2], axes[0] / view.projection[0][0], axes[1] / view.projection[1][1]};
  const bool buried = view.eye.y <= 0;  // below the ground: earth all around
  const Part above = buried ? part_of_viewport(1, 0, 0) : part_of_viewport(rays.forward.y, rays.right.y, rays.up.y);
  const Part below = buried ? Part{} : part_of_viewport(-rays.forward.y, -rays.right.y, -rays.up.y);
  blend(pass.gl, false);
  pass.gl.Disable(GL_DEPTH_TEST);
  pass.gl.BindVertexArray(pass.no_attributes);
  if (above.count > 2) {
    const Program& sky = pass.programs.sky;
    sky.use();
    sky.set("pixel", 2.0f / (view.projection[1][1] * std::max(view.viewport.height, 1.0f)));
    draw_part(pass, sky, rays, above);
  }
  if (below.count > 2) draw_ground(pass, shadows, rays, below);
}

}  // namespace coaster::gfx
