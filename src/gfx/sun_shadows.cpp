#include "gfx/sun_shadows.h"

#include <algorithm>

namespace coaster::gfx {
namespace {

constexpr float kTrackSide = 256, kTrainSide = 16;  // m, the smallest squares

// Returns the texels per side: no more than the picture can show, which matters for small pictures, but so many that
// one is smaller than the track is wide: wider ones shade the track itself where the light grazes it.
int texels_for(const view::Viewport& viewport) {
  int size = 1024;
  while (size < 2048 && static_cast<float>(size) < 2 * std::max(viewport.width, viewport.height)) size *= 2;
  return size;
}

bool same(const sim::Pose& a, const sim::Pose& b) {
  return a.position == b.position && a.frame.forward == b.frame.forward && a.frame.up == b.frame.up &&
         a.length == b.length && a.leads == b.leads;
}

}  // namespace

void SunShadows::update(const Pass& pass, TrackCache& track, const Instances& instances) {
  const Scene& scene = pass.scene;
  const SunAxes axes(pass.scenery.sun);
  const glm::vec3 eye = scene.view.eye, forward = view::line_of_sight(scene.view);
  if (!std::equal(cars_.begin(), cars_.end(), scene.carts.begin(), scene.carts.end(), same)) {
    cars_.assign(scene.carts.begin(), scene.carts.end());
    ++cars_version_;
  }
  const int texels = scene.shadows ? texels_for(scene.view.viewport) : 4;
  const auto fit = [&](const LightBox& box, float least) {
    return fit_shadow(axes, scene.shadows ? box : LightBox{}, least, eye, forward);
  };
  const ShadowFit square = fit(track_box_.update(axes, scene.derived), kTrackSide);
  const float texel_metres = square.side / static_cast<float>(texels);
  if (track_.update(texels, axes, square, track.mesh_version(), scene.unseen,
                    [&](const glm::mat4& light) { cast_track(pass, track, light, texel_metres); }))
    ++pass.stats.shadow_maps;
  if (trains_.update(texels / 4, axes, fit(light_box(axes, scene.carts), kTrainSide), cars_version_, scene.unseen,
                     [&](const glm::mat4& light) { cast_carts(pass, instances, light); }))
    ++pass.stats.shadow_maps;
}

void SunShadows::bind(const Program& program) const {
  program.set("taps", 4);
  track_.bind(program, "track", kTrackShadowUnit);
  trains_.bind(program, "train", kTrainShadowUnit);
}

}  // namespace coaster::gfx
