// The passes of a picture, from far to near: backdrop, shadows, track, carts, polyline, overlay. What the passes draw is kept by
// TrackCache and Instances, how they look is in shaders/.
#include "gfx/renderer.h"

#include <algorithm>
#include <cstring>
#include <optional>

#include "gfx/curve_deviation.h"
#include "gfx/draw_state.h"
#include "gfx/gpu_timer.h"
#include "gfx/instances.h"
#include "gfx/scene_programs.h"
#include "gfx/scenery.h"
#include "gfx/track_cache.h"
#include "gfx/value_texture.h"
#include "view/colour_map.h"

namespace coaster::gfx {
namespace {

constexpr float kPolylineWidth = 1.75f;  // px
constexpr glm::vec4 kPolylineColour{1, 1, 1, 0.9f};

}  // namespace

struct Renderer::Parts {
  const Gl& gl;
  ScenePrograms programs;
  TrackCache track;
  Instances instances;
  CurveStages stages;
  ValueTexture values;  // what the track is coloured by
  CurveDeviation deviation;
  GpuTimer polyline_timer;
  Object empty_array;  // for the backdrop, which has no attributes
  int samples = 0;     // asked for and within the driver's limits
  // `scene` exists when multisampled; `resolved` is drawn to directly otherwise.
  std::optional<Target> scene, resolved;

  Parts(const Gl& table, ScenePrograms compiled)
      : gl(table), programs(std::move(compiled)), track(table), instances(table), stages(table), values(table), deviation(table), polyline_timer(table),
        empty_array(make_vertex_array(table)) {}

  void fit_targets(int width, int height);
  void begin(const view::Viewport& viewport, glm::vec3 around, int width, int height);
  void draw_backdrop(const view::View& view, const Scenery& scenery, DrawStats& stats);
  void draw_meshes(const Program& track_program, const Program& cart_program, const Scene& scene, DrawStats& stats);
  void draw_shadows(const Scene& scene, DrawStats& stats);
  void set_colouring(const Scene& scene);
  void draw_solids(const Scene& scene, DrawStats& stats);
  void draw_lines(const Scene& scene, curve::Stage stage);
  void draw_polyline(const Scene& scene, DrawStats& stats);
  void draw_overlay(const Scene& scene, DrawStats& stats);
  void finish(int width, int height);
};

// Makes the framebuffers anew when size or samples changed. A driver that refuses multisampling of this size gets none.
void Renderer::Parts::fit_targets(int width, int height) {
  const int have = scene ? scene->samples : 0;
  if (resolved && resolved->width == width && resolved->height == height && have == samples) return;
  scene.reset();
  resolved.reset();
  auto plain = make_target(gl, width, height, 0);
  COASTER_CHECK(plain.ok(), "the driver has framebuffers of the size of its screens");
  resolved = std::move(*plain);
  if (samples == 0) return;
  if (auto target = make_target(gl, width, height, samples))
    scene = std::move(*target);
  else
    samples = 0;
}

void Renderer::Parts::begin(const view::Viewport& viewport, glm::vec3 around, int width, int height) {
  gl.BindFramebuffer(GL_FRAMEBUFFER, scene ? scene->framebuffer.id() : resolved->framebuffer.id());
  gl.Viewport(0, 0, width, height);
  gl.Disable(GL_SCISSOR_TEST);
  gl.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  gl.DepthMask(GL_TRUE);
  gl.ClearColor(around.x, around.y, around.z, 1);
  gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
  const Rectangle r = pixels_of(viewport, width, height);
  gl.Viewport(r.x, r.y, r.width, r.height);
  gl.Scissor(r.x, r.y, r.width, r.height);
  gl.Enable(GL_SCISSOR_TEST);
}

void Renderer::Parts::draw_backdrop(const view::View& view, const Scenery& scenery, DrawStats& stats) {
  // Rows of the view matrix are the camera's axes in the world; the projection is symmetric.
  const glm::mat3 axes = glm::transpose(glm::mat3(view.view));
  programs.backdrop.use();
  programs.backdrop.set("forward", -axes[2]);
  programs.backdrop.set("right", axes[0] / view.projection[0][0]);
  programs.backdrop.set("up", axes[1] / view.projection[1][1]);
  programs.backdrop.set("eye", view.eye);
  programs.backdrop.set("horizon", scenery.horizon);
  programs.backdrop.set("zenith", scenery.zenith);
  programs.backdrop.set("ground_colour", scenery.ground);
  programs.backdrop.set("grid_light", scenery.grid_light);
  programs.backdrop.set("glow_strength", scenery.glow);
  blend(gl, false);
  gl.Disable(GL_DEPTH_TEST);
  gl.BindVertexArray(empty_array.id());
  gl.DrawArrays(GL_TRIANGLES, 0, 3);
  ++stats.draw_calls;
}

void Renderer::Parts::draw_meshes(const Program& track_program, const Program& cart_program, const Scene& picture, DrawStats& stats) {
  const glm::mat4 view_projection = picture.view.projection * picture.view.view;
  const Scenery& scenery = scenery_of(picture.theme);
  const auto light = [&](const Program& program) {  // solids and shadows have each their own of these
    program.set("horizon", scenery.horizon);
    program.set("lift", scenery.lift);
    program.set("tone", scenery.shadow);
  };
  if (track.index_count() > 0) {
    track_program.use();
    light(track_program);
    track_program.set("view_projection", view_projection);
    track_program.set("eye", picture.view.eye);
    track.bind_mesh();
    gl.DrawElements(GL_TRIANGLES, track.index_count(), GL_UNSIGNED_INT, nullptr);
    ++stats.draw_calls;
  }
  if (const GLsizei carts = instances.bind_carts(); carts > 0) {
    cart_program.use();
    light(cart_program);
    cart_program.set("view_projection", view_projection);
    cart_program.set("eye", picture.view.eye);
    gl.DrawElementsInstanced(GL_TRIANGLES, instances.cart_indices(), GL_UNSIGNED_INT, nullptr, carts);
    ++stats.draw_calls;
  }
}

// On the ground plane, which is all backdrop so far: no depth is needed, and the stencil darkens each sample once. Faces
// towards the sun keep their winding when seen from above, so half of the triangles suffice.
void Renderer::Parts::draw_shadows(const Scene& picture, DrawStats& stats) {
  if (picture.view.eye.y <= 0) return;
  blend(gl, true);
  gl.Disable(GL_DEPTH_TEST);
  gl.Enable(GL_CULL_FACE);
  gl.CullFace(GL_BACK);
  gl.Enable(GL_STENCIL_TEST);
  gl.StencilFunc(GL_EQUAL, 0, 0xff);
  gl.StencilOp(GL_KEEP, GL_KEEP, GL_INCR);
  draw_meshes(programs.track_shadow, programs.cart_shadow, picture, stats);
  gl.Disable(GL_STENCIL_TEST);
  gl.Disable(GL_CULL_FACE);
}

// The track by the scene's values; the program is in use afterwards.
void Renderer::Parts::set_colouring(const Scene& picture) {
  const bool coloured = picture.values != nullptr && !picture.values->values.empty();
  programs.track.use();
  programs.track.set("colouring", coloured ? 1 : 0);
  programs.track.set("values", 0);
  // 1.6 pixels: the projection scales a metre at a distance of one to as much of half the viewport's height.
  programs.track.set("least_width", coloured ? 3.2f / (picture.view.projection[1][1] * picture.view.viewport.height) : 0.0f);
  values.bind();  // a sampler reads something, asked or not
  if (!coloured) return;
  programs.track.set("value_range", glm::vec2(picture.values->low, picture.values->high));
  programs.track.set("unknown", view::kUnknownColour);
  for (std::size_t i = 0; i < view::kColourStops.size(); ++i) programs.track.set(("stops[" + std::to_string(i) + "]").c_str(), view::kColourStops[i]);
}

void Renderer::Parts::draw_solids(const Scene& picture, DrawStats& stats) {
  blend(gl, false);
  gl.Enable(GL_DEPTH_TEST);
  gl.DepthFunc(GL_LESS);
  gl.Enable(GL_CULL_FACE);
  gl.CullFace(GL_BACK);
  set_colouring(picture);
  draw_meshes(programs.track, programs.carts, picture, stats);
  gl.Disable(GL_CULL_FACE);
}

// The polyline's quads: from cached vertices, or from control points by the stage that evaluates them.
void Renderer::Parts::draw_lines(const Scene& picture, curve::Stage stage) {
  const view::View& view = picture.view;
  const PolylinePen pen{view.projection * view.view, view.eye, {view.viewport.width, view.viewport.height}, kPolylineWidth, kPolylineColour};
  if (stage != curve::Stage::processor)
    return stages.draw(stage, {track.control_buffer(), 0, int(track.placed().size()), picture.derived.steps}, pen);
  programs.polyline.use();
  pen.set(programs.polyline);
  track.bind_lines();
  gl.DrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, track.line_count());
}

// Lines meet and cross: their coverage is gathered in the alpha channel by maximum and painted in one go. So the picture depends
// neither on where in the buffer the segments lie nor on how many lines cover a pixel.
void Renderer::Parts::draw_polyline(const Scene& picture, DrawStats& stats) {
  if (!picture.show_polyline || picture.derived.order.empty()) return;
  gl.ColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_TRUE);
  gl.ClearColor(0, 0, 0, 0);
  gl.Clear(GL_COLOR_BUFFER_BIT);
  gl.Enable(GL_BLEND);
  gl.BlendEquation(GL_MAX);
  gl.Enable(GL_DEPTH_TEST);
  gl.DepthFunc(GL_LEQUAL);
  gl.DepthMask(GL_FALSE);
  polyline_timer.begin();
  draw_lines(picture, stats.drawn_by);
  polyline_timer.end();
  stats.gpu_ms = polyline_timer.ms();
  gl.DepthMask(GL_TRUE);
  gl.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  gl.Disable(GL_DEPTH_TEST);
  gl.BlendEquation(GL_FUNC_ADD);
  gl.BlendFuncSeparate(GL_DST_ALPHA, GL_ONE_MINUS_DST_ALPHA, GL_ONE, GL_ZERO);  // leaves the picture opaque
  programs.coverage.use();
  programs.coverage.set("paint", glm::vec4(glm::vec3(kPolylineColour), 1));
  gl.BindVertexArray(empty_array.id());
  gl.DrawArrays(GL_TRIANGLES, 0, 3);
  stats.draw_calls += 2;
}

void Renderer::Parts::draw_overlay(const Scene& picture, DrawStats& stats) {
  blend(gl, true);
  gl.Disable(GL_DEPTH_TEST);
  const auto pass = [&](const Program& program, GLsizei count) {
    if (count == 0) return;
    program.use();
    program.set("view_projection", picture.view.projection * picture.view.view);
    program.set("viewport", glm::vec2(picture.view.viewport.width, picture.view.viewport.height));
    gl.DrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, count);
    ++stats.draw_calls;
  };
  pass(programs.line, instances.bind_lines());
  pass(programs.mark, instances.bind_marks());
}

void Renderer::Parts::finish(int width, int height) {
  blend(gl, false);
  gl.Disable(GL_SCISSOR_TEST);  // it would cut the copy
  gl.BindVertexArray(0);
  gl.UseProgram(0);
  if (scene) {
    gl.BindFramebuffer(GL_READ_FRAMEBUFFER, scene->framebuffer.id());
    gl.BindFramebuffer(GL_DRAW_FRAMEBUFFER, resolved->framebuffer.id());
    gl.BlitFramebuffer(0, 0, width, height, 0, 0, width, height, GL_COLOR_BUFFER_BIT, GL_NEAREST);
  }
  gl.BindFramebuffer(GL_FRAMEBUFFER, resolved->framebuffer.id());
  gl.Viewport(0, 0, width, height);
}

base::Result<std::unique_ptr<Renderer>> Renderer::make(const Gl& gl, int samples) {
  auto programs = make_scene_programs(gl);
  if (!programs) return programs.status();
  std::unique_ptr<Renderer> renderer(new Renderer(std::make_unique<Parts>(gl, std::move(*programs))));
  renderer->set_samples(samples);
  return renderer;
}

Renderer::Renderer(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}
Renderer::~Renderer() = default;

std::string Renderer::refusal(curve::Stage stage) const { return parts_->stages.refusal(stage); }

void Renderer::set_samples(int samples) {
  const int clamped = std::clamp(samples, 0, parts_->gl.max_samples);
  parts_->samples = clamped > 1 ? clamped : 0;
}

DrawStats Renderer::draw(const Scene& scene, int width, int height) {
  COASTER_CHECK(width >= 1 && height >= 1, "a picture has pixels");
  Parts& parts = *parts_;
  DrawStats stats;
  const TrackCache::Synced synced = parts.track.sync(scene.derived, scene.clock);
  stats.uploads = synced.uploads;
  stats.cpu_ms = 1000 * synced.cpu_seconds;
  stats.upload_bytes = synced.bytes;
  stats.polyline_upload_bytes = synced.polyline_bytes;
  stats.polyline_bytes = parts.track.held_polyline_bytes();
  stats.drawn_by = parts.stages.usable(scene.derived.stage);
  if (stats.drawn_by != curve::Stage::processor) {
    const CurveDeviation::Result measured = parts.deviation.update(parts.stages, stats.drawn_by, parts.track, scene.derived);
    stats.deviation = measured.metres;
    stats.deviation_pending = measured.pending;
  }
  if (scene.values) stats.recolours = parts.values.sync(scene.derived, *scene.values).recolours;
  parts.instances.upload(scene.overlay, scene.carts);
  parts.fit_targets(width, height);
  stats.samples = parts.samples;
  parts.begin(scene.view.viewport, scenery_of(scene.theme).around, width, height);
  parts.draw_backdrop(scene.view, scenery_of(scene.theme), stats);
  parts.draw_shadows(scene, stats);
  parts.draw_solids(scene, stats);
  parts.draw_polyline(scene, stats);
  parts.draw_overlay(scene, stats);
  parts.finish(width, height);
  return stats;
}

unsigned Renderer::framebuffer() const { return parts_->resolved ? parts_->resolved->framebuffer.id() : 0; }

Image Renderer::read_pixels() const {
  COASTER_CHECK(parts_->resolved, "pixels are read after a draw");
  const Gl& gl = parts_->gl;
  const int width = parts_->resolved->width, height = parts_->resolved->height;
  const std::size_t row = 4 * std::size_t(width);
  std::vector<std::uint8_t> upside_down(row * std::size_t(height));
  gl.BindFramebuffer(GL_READ_FRAMEBUFFER, parts_->resolved->framebuffer.id());
  gl.PixelStorei(GL_PACK_ALIGNMENT, 4);
  gl.ReadPixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, upside_down.data());
  Image image{width, height, std::vector<std::uint8_t>(upside_down.size())};
  for (int y = 0; y < height; ++y)
    std::memcpy(&image.rgba[std::size_t(y) * row], &upside_down[std::size_t(height - 1 - y) * row], row);
  return image;
}

}  // namespace coaster::gfx
