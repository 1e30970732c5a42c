// One triangle over the viewport; its shader follows the ray of each pixel.
#include "gfx/draw_state.h"
#include "gfx/passes.h"
#include "gfx/sun_shadows.h"

namespace coaster::gfx {

void draw_backdrop(const Pass& pass, const SunShadows& shadows) {
  const view::View& view = pass.scene.view;
  // Rows of the view matrix are the camera's axes in the world; the projection is symmetric.
  const glm::mat3 axes = glm::transpose(glm::mat3(view.view));
  const Program& program = pass.programs.backdrop;
  program.use();
  program.set("forward", -axes[2]);
  program.set("right", axes[0] / view.projection[0][0]);
  program.set("up", axes[1] / view.projection[1][1]);
  program.set("eye", view.eye);
  program.set("pixel", 2.0f / (view.projection[1][1] * std::max(view.viewport.height, 1.0f)));
  shadows.bind(program);
  blend(pass.gl, false);
  pass.gl.Disable(GL_DEPTH_TEST);
  pass.gl.BindVertexArray(pass.no_attributes);
  pass.gl.DrawArrays(GL_TRIANGLES, 0, 3);
  pass.count(1);
}

}  // namespace coaster::gfx
