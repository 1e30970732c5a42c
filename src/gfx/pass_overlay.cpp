// The overlay's lines and marks, one instance each.
#include "gfx/passes.h"

namespace coaster::gfx {

constexpr float kMarkRim = 1.5f;  // points

void draw_overlay(const Pass& pass, const Instances& instances) {
  blend(pass.gl, true);
  pass.gl.Disable(GL_DEPTH_TEST);
  const view::Viewport& viewport = pass.scene.view.viewport;
  const auto draw = [&](const Program& program, GLsizei count) {
    if (count == 0) return;
    program.use();
    program.set("view_projection", pass.view_projection);
    program.set("viewport", glm::vec2(viewport.width, viewport.height));
    if (!pass.scene.unseen) pass.gl.DrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, count);
    pass.count(2LL * count);
  };
  draw(pass.programs.line, instances.bind_lines());
  pass.programs.mark.use();
  pass.programs.mark.set("rim", kMarkRim * pass.scene.view.density);
  draw(pass.programs.mark, instances.bind_marks());
}

}  // namespace coaster::gfx
