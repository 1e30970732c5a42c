// The passes of a picture, each in its pass_*.cpp. Between passes blending, depth test and culling are undefined: each
// sets what it needs.
#pragma once

#include "gfx/curve_stages.h"
#include "gfx/gpu_timer.h"
#include "gfx/instances.h"
#include "gfx/renderer.h"
#include "gfx/scene_programs.h"
#include "gfx/scenery.h"
#include "gfx/track_cache.h"
#include "gfx/value_texture.h"

namespace coaster::gfx {

class SunShadows;

// What all passes of one picture have in common.
struct Pass {
  const Gl& gl;
  const ScenePrograms& programs;
  const Scene& scene;
  const Scenery& scenery;
  glm::mat4 view_projection;
  GLuint no_attributes;  // a vertex array without any
  DrawStats& stats;

  void count(std::int64_t triangles) const {
    ++stats.draw_calls;
    stats.triangles += triangles;
  }
};

// Texture units.
inline constexpr int kValueUnit = 0, kTrackShadowUnit = 1, kTrainShadowUnit = 3;

// What is so far off that a rail is no wider than two pixels is drawn with fewer triangles from now on.
void choose_detail(const view::View& view, TrackCache& track);

// Sky and ground with the shadows on it.
void draw_backdrop(const Pass& pass, const SunShadows& shadows);

// Track and train as the sun sees them, into a shadow map.
void cast_track(const Pass& pass, const TrackCache& track, const glm::mat4& light);
void cast_carts(const Pass& pass, const Instances& instances, const glm::mat4& light);

// Track and train; in a drawing their lines first, as what looks out behind them.
void draw_solids(const Pass& pass, const TrackCache& track, const Instances& instances, ValueTexture& values,
                 const SunShadows& shadows);

// The laboratory's polyline. `timer` measures it on the GPU.
void draw_polyline(const Pass& pass, const TrackCache& track, CurveStages& stages, GpuTimer& timer);

// Lines and marks over everything.
void draw_overlay(const Pass& pass, const Instances& instances);

}  // namespace coaster::gfx
