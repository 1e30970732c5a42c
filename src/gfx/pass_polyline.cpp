// The polyline. Its lines meet and cross, so their coverage is accumulated in the alpha channel by maximum and painted
// at once. The picture depends neither on the order of the segments in the buffer nor on the number of lines over a
// pixel.
#include "gfx/passes.h"

namespace coaster::gfx {
namespace {

constexpr float kPolylineWidth = 1.75f;  // points
constexpr glm::vec4 kPolylineColour{1, 1, 1, 0.9f};

// Draws the polyline's quads: from cached vertices, or from control points by the stage that evaluates them.
void draw_lines(const Pass& pass, const TrackCache& track, GpuCurves& curves) {
  const view::View& view = pass.scene.view;
  const PolylinePen pen{pass.view_projection,
                        view.eye,
                        {view.viewport.width, view.viewport.height},
                        kPolylineWidth * view.density,
                        kPolylineColour};
  if (pass.stats.drawn_by != curve::EvaluatedBy::processor) {
    for (const CurveSlots& run : track.control_runs()) {
      pass.count(2LL * run.count * run.steps);
      if (!pass.scene.unseen) curves.draw(pass.stats.drawn_by, run, pen);
    }
    return;
  }
  pen.set(pass.use(SceneProgram::polyline));
  track.bind_lines();
  if (!pass.scene.unseen) pass.gl.DrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, track.line_count());
  pass.count(2LL * track.line_count());
}

}  // namespace

void draw_polyline(const Pass& pass, const TrackCache& track, GpuCurves& curves, GpuTimer& timer) {
  if (!pass.scene.show_polyline || pass.scene.derived.order.empty()) return;
  const Gl& gl = pass.gl;
  gl.ColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_TRUE);
  gl.ClearColor(0, 0, 0, 0);
  gl.Clear(GL_COLOR_BUFFER_BIT);
  gl.Enable(GL_BLEND);
  gl.BlendEquation(GL_MAX);
  gl.Enable(GL_DEPTH_TEST);
  gl.DepthFunc(GL_LEQUAL);
  gl.DepthMask(GL_FALSE);
  timer.begin();
  draw_lines(pass, track, curves);
  timer.end();
  pass.stats.gpu_ms = timer.ms();
  gl.DepthMask(GL_TRUE);
  gl.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  gl.Disable(GL_DEPTH_TEST);
  gl.BlendEquation(GL_FUNC_ADD);
  gl.BlendFuncSeparate(GL_DST_ALPHA, GL_ONE_MINUS_DST_ALPHA, GL_ONE, GL_ZERO);  // keeps the picture opaque
  pass.use(SceneProgram::coverage).set("paint", glm::vec4(glm::vec3(kPolylineColour), 1));
  gl.BindVertexArray(pass.no_attributes);
  if (!pass.scene.unseen) gl.DrawArrays(GL_TRIANGLES, 0, 3);
  pass.count(1);
}

}  // namespace coaster::gfx
