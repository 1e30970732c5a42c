// The overlay's lines and marks, one instance each.
#include "gfx/passes.h"

namespace coaster::gfx {

constexpr float kMarkRim = 1.5f;  // points

void draw_overlay(const Pass& pass, const Instances& instances) {
  blend(pass.gl, true);
  pass.gl.Disable(GL_DEPTH_TEST);
  const view::Viewport& viewport = pass.scene.view.viewport;
  const auto draw = [&](SceneProgram name, GLsizei count) {
    if (count == 0) return;
    const Program& program = pass.use(name);
    program.set("rim", kMarkRim * pass.scene.view.density);
    program.set("view_projection", pass.view_projection);
    program.set("viewport", glm::vec2(viewport.width, viewport.height));
    if (!pass.scene.unseen) pass.gl.DrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, count);
    pass.count(2LL * count);
  };
  draw(SceneProgram::line, instances.bind_lines());
  draw(SceneProgram::mark, instances.bind_marks());
}

}  // namespace coaster::gfx
