// Ground and sky on their sides of the horizon, by shaders that follow the ray of each pixel.
#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "gfx/passes.h"
#include "gfx/sun_shadows.h"

namespace coaster::gfx {
namespace {

// A convex part of the viewport, -1 to 1, with the number of corners that the shader expects.
struct Part {
  std::array<glm::vec2, 6> corners{};
  int count = 0;
};

// Returns the part where a + b x + c y is not negative.
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
  glm::vec3 forward, right, up;            // right and up: to the viewport's edges at distance 1
  glm::vec3 eye, eye_right{0}, eye_up{0};  // m; origin of the rays, and its change towards the edges
};

void draw_part(const Pass& pass, const Program& program, const Rays& rays, const Part& part) {
  program.set("forward", rays.forward);
  program.set("right", rays.right);
  program.set("up", rays.up);
  program.set("eye", rays.eye);
  program.set("eye_right", rays.eye_right);
  program.set("eye_up", rays.eye_up);
  for (std::size_t i = 0; i < part.corners.size(); ++i)
    program.set(fmt::format("corners[{}]", i).c_str(), part.corners[i]);
  if (!pass.scene.unseen) pass.gl.DrawArrays(GL_TRIANGLE_FAN, 0, part.count);
  pass.count(part.count - 2);
}

// Draws twice: the sunlit ground, which writes depth 0.5 where a shadow may be; then the shadows, only there. Pixels
// without shadow therefore cost little.
void draw_ground(const Pass& pass, const SunShadows& shadows, const Rays& rays, const Part& part) {
  const Gl& gl = pass.gl;
  const Program& ground = pass.use(SceneProgram::ground);
  shadows.bind(ground);
  gl.Enable(GL_DEPTH_TEST);
  gl.DepthFunc(GL_ALWAYS);
  draw_part(pass, ground, rays, part);
  if (!pass.scene.shadows) {
    gl.Clear(GL_DEPTH_BUFFER_BIT);
    return;
  }
  const Program& shadow = pass.use(SceneProgram::ground_shadow);
  shadows.bind(shadow);
  gl.DepthFunc(GL_EQUAL);
  gl.DepthMask(GL_FALSE);
  gl.Enable(GL_BLEND);
  gl.BlendEquation(GL_FUNC_ADD);
  gl.BlendFuncSeparate(GL_DST_COLOR, GL_ZERO, GL_ZERO, GL_ONE);
  draw_part(pass, shadow, rays, part);
  gl.DepthMask(GL_TRUE);
  gl.Clear(GL_DEPTH_BUFFER_BIT);
}

void draw_sky(const Pass& pass, const Rays& rays, const Part& part) {
  if (part.count < 3) return;
  const view::View& view = pass.scene.view;
  const float by_distance = view.parallel > 0 ? view.parallel : 1;
  const Program& program = pass.use(SceneProgram::sky);
  program.set("pixel", view::metres_per_pixel(view, 1) / by_distance);
  draw_part(pass, program, rays, part);
}

// An orthographic view from above shows only ground. One along the ground shows it as a line: earth below it, and above
// it the sky of a perspective view with the same horizon.
void draw_parallel_backdrop(const Pass& pass, const SunShadows& shadows) {
  const view::View& view = pass.scene.view;
  const glm::mat3 axes = glm::transpose(glm::mat3(view.view));
  const glm::vec3 right = axes[0] / view.projection[0][0], up = axes[1] / view.projection[1][1];
  if (axes[2].y > 0.5f) {
    const Rays down{-axes[2], glm::vec3(0), glm::vec3(0), view.eye, right, up};
    return draw_ground(pass, shadows, down, part_of_viewport(1, 0, 0));
  }
  const float middle = view.eye.y / up.y;  // height of the picture's middle over the ground, in halves of the picture
  const glm::vec3 right_at_1 = right / view.parallel, up_at_1 = up / view.parallel;
  const Rays over{-axes[2] + middle * up_at_1, right_at_1, up_at_1, {0, 1, 0}},
      under{over.forward, over.right, over.up, {0, -1, 0}};
  draw_sky(pass, over, part_of_viewport(middle, 0, 1));
  draw_sky(pass, under, part_of_viewport(-middle, 0, -1));
}

}  // namespace

void draw_backdrop(const Pass& pass, const SunShadows& shadows) {
  const view::View& view = pass.scene.view;
  blend(pass.gl, false);
  pass.gl.Disable(GL_DEPTH_TEST);
  pass.gl.BindVertexArray(pass.no_attributes);
  if (view.parallel > 0) return draw_parallel_backdrop(pass, shadows);
  // Rows of the view matrix are the camera's axes in the world; the projection is symmetric.
  const glm::mat3 axes = glm::transpose(glm::mat3(view.view));
  const Rays rays{-axes[2], axes[0] / view.projection[0][0], axes[1] / view.projection[1][1], view.eye};
  const bool buried = view.eye.y <= 0;  // below the ground: earth all around
  const Part above = buried ? part_of_viewport(1, 0, 0) : part_of_viewport(rays.forward.y, rays.right.y, rays.up.y);
  const Part below = buried ? Part{} : part_of_viewport(-rays.forward.y, -rays.right.y, -rays.up.y);
  draw_sky(pass, rays, above);
  if (below.count > 2) draw_ground(pass, shadows, rays, below);
}

}  // namespace coaster::gfx
