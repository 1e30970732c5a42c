// The shadow maps of a scene, one of the track and one of the trains. A map is redrawn only if its casters, the light
// or the visible part of the scene have changed.
#pragma once

#include <vector>

#include "gfx/passes.h"
#include "gfx/shadow_map.h"

namespace coaster::gfx {

class SunShadows {
 public:
  explicit SunShadows(const Gl& gl) : track_(gl), trains_(gl) {}
  // Counts the drawn maps in stats.shadow_maps. Call after updating `track` and `instances`; binds framebuffers.
  void update(const Pass& pass, TrackCache& track, const Instances& instances);
  // For the program in use.
  void bind(const Program& program) const;

 private:
  ShadowMap track_, trains_;
  TrackBox track_box_;
  std::vector<sim::Pose> cars_;  // poses of the last `trains_` map
  std::uint64_t cars_version_ = 1;
};

}  // namespace coaster::gfx
