// The list of passes of a picture, from far to near. TrackCache and CarInstances hold the geometry; shaders/ and the
// table of styles (gfx/scenery) define the look.
#include "gfx/renderer.h"

#include <algorithm>
#include <memory>
#include <utility>

#include "gfx/frame_targets.h"
#include "gfx/gpu_curves.h"
#include "gfx/park_passes.h"
#include "gfx/passes.h"
#include "gfx/soft_quads.h"
#include "gfx/sun_shadows.h"
#include "world/appearance_settings.h"

namespace coaster::gfx {

struct Renderer::Parts {
  Parts(const Gl& of, std::shared_ptr<ScenePrograms> shared, GpuCurves curves)
      : gl(of), programs(std::move(shared)), gpu_curves(std::move(curves)) {}

  const Gl& gl;
  std::shared_ptr<ScenePrograms> programs;
  GpuCurves gpu_curves;
  SceneStyleBuffer air{gl};
  TrackCache track{gl};
  CarInstances instances{gl};
  ValueTexture values{gl};  // colours of the track
  SectionPaint paint{gl};
  CurveDeviation deviation{gl};
  SunShadows shadows{gl};
  ParkPasses park{gl};
  SoftQuads quads{gl};
  GpuTimer polyline_timer{gl};
  GlObject empty_array = make_vertex_array(gl);  // for triangles without attributes
  FrameTargets targets{gl};

  void upload(const Scene& scene, DrawStats& stats);
};

// Updates the buffers from the scene: writes only what has changed, except for the few bytes of overlay and poses.
void Renderer::Parts::upload(const Scene& scene, DrawStats& stats) {
  choose_levels(scene, track);
  const TrackCache::UploadStats synced = track.sync(scene.derived, scene.clock, scene.ground);
  const SupportCache::UploadStats held =
      track.supports().sync(scene.supports, scene.clock, track.near(), scene.derived.made.kind);
  stats.uploads = synced.uploads;
  stats.support_uploads = held.uploads;
  stats.prepare_ms = 1000 * (synced.cpu_seconds + held.cpu_seconds);
  stats.upload_bytes = synced.bytes;
  stats.polyline_upload_bytes = synced.polyline_bytes;
  stats.polyline_bytes = track.held_polyline_bytes();
  stats.drawn_by = gpu_curves.usable(scene.derived.evaluated_by);
  if (stats.drawn_by != curve::EvaluatedBy::processor) {
    const CurveDeviation::Result measured = deviation.update(gpu_curves, stats.drawn_by, track, scene.derived);
    stats.deviation = measured.metres;
    stats.deviation_pending = measured.pending;
  }
  if (scene.values) stats.recolours = values.sync(scene.derived, *scene.values).recolours;
  paint.sync(scene.derived, scene.document);
  instances.upload(scene.overlay, scene.carts, scene.view.eye, scene.derived.made.kind);
  if (ParkPasses::shows(scene)) park.upload(scene, scenery_of(scene.style), stats);
  stats.park_upload_bytes += track.sync_buildings(scene.stations);
  if (scene.scenery != world::Scenery::plain && scene.ground != nullptr) quads.upload(scene, track.mesh_version());
}

Renderer::Renderer(const Gl& gl, int samples)
    : Renderer(std::make_unique<Parts>(gl, std::make_shared<ScenePrograms>(gl), GpuCurves(gl)), samples) {}

std::unique_ptr<Renderer> Renderer::sibling(int samples) const {
  auto parts = std::make_unique<Parts>(parts_->gl, parts_->programs, parts_->gpu_curves.sibling());
  return std::unique_ptr<Renderer>(new Renderer(std::move(parts), samples));
}

Renderer::Renderer(std::unique_ptr<Parts> parts, int samples) : parts_(std::move(parts)) { set_samples(samples); }
Renderer::~Renderer() = default;

std::string Renderer::refusal(curve::EvaluatedBy stage) const { return parts_->gpu_curves.refusal(stage); }

const base::Status& Renderer::failure() const { return parts_->programs->failure(); }

void Renderer::set_samples(int samples) { parts_->targets.set_samples(samples); }

std::string Renderer::take_notice() { return parts_->targets.take_notice(); }

DrawStats Renderer::draw(const Scene& scene, int width, int height) {
  COASTER_CHECK(width >= 1 && height >= 1, "a picture has at least one pixel");
  Parts& parts = *parts_;
  DrawStats stats;
  const SceneStyle& scenery = scenery_of(scene.style);
  parts.air.bind(scenery);
  parts.upload(scene, stats);
  choose_detail(scene, parts.track);
  parts.targets.fit(width, height);
  stats.samples = parts.targets.samples();
  PassContext pass{
      parts.gl, *parts.programs, scene, scenery, scene.view.projection * scene.view.view, parts.empty_array.id(),
      stats};
  pass.park = ParkPasses::shows(scene);
  SunShadows::ParkCasters casters;
  if (pass.park) {
    pass.cast_heights = parts.park.cast_heights();
    pass.lit = scenery.night;
    parts.park.look(pass);
    casters = parts.park.casters(pass);
  }
  parts.shadows.update(pass, parts.track, parts.instances, pass.park ? &casters : nullptr);
  parts.targets.begin(scene.view.viewport, around_of(scene.theme), scene.unseen);
  if (pass.park) parts.park.draw_land(pass, parts.shadows);
  else draw_backdrop(pass, parts.shadows);
  const bool scenic = scene.scenery != world::Scenery::plain && scene.ground != nullptr && !scenery.drawing;
  if (scenic) parts.quads.draw_contact(pass);
  draw_solids(pass, parts.track, parts.instances, parts.values, parts.paint, parts.shadows);
  if (pass.park) parts.park.draw_sky_and_water(pass, parts.shadows);
  if (scenic) parts.quads.draw_spray(pass);
  draw_polyline(pass, parts.track, parts.gpu_curves, parts.polyline_timer);
  draw_overlay(pass, parts.instances);
  parts.targets.finish();
  return stats;
}

unsigned Renderer::framebuffer() const {
  const RenderTarget* const resolved = parts_->targets.resolved();
  return resolved ? resolved->framebuffer.id() : 0;
}

Image Renderer::read_pixels() const {
  const RenderTarget* const resolved = parts_->targets.resolved();
  COASTER_CHECK(resolved, "pixels are read after a draw");
  const Gl& gl = parts_->gl;
  const int width = resolved->width, height = resolved->height;
  const std::size_t row = 4 * std::size_t(width);
  Image image{width, height, std::vector<std::uint8_t>(row * std::size_t(height))};
  gl.BindFramebuffer(GL_READ_FRAMEBUFFER, resolved->framebuffer.id());
  gl.PixelStorei(GL_PACK_ALIGNMENT, 4);
  gl.ReadPixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, image.rgba.data());
  for (std::size_t y = 0; y < std::size_t(height) / 2; ++y) {  // OpenGL's first row is the lowest one
    const auto top = image.rgba.begin() + std::ptrdiff_t(y * row);
    std::swap_ranges(top, top + std::ptrdiff_t(row), image.rgba.end() - std::ptrdiff_t((y + 1) * row));
  }
  return image;
}

}  // namespace coaster::gfx
