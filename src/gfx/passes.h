// The passes of a picture and their shader programs, from the sources in shaders/ that the build embeds.
#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "base/status.h"
#include "gfx/gl_objects.h"
#include "gfx/gpu_curves.h"
#include "gfx/per_frame_instances.h"
#include "gfx/renderer.h"
#include "gfx/scenery.h"
#include "gfx/section_paint.h"
#include "gfx/track_cache.h"
#include "gfx/value_texture.h"

namespace coaster::gfx {

enum class SceneProgram {
  ground,
  ground_shadow,
  sky,
  solid,
  outline,
  shadow,
  polyline,
  coverage,
  line,
  mark,
  // Of scenery that is not plain, and of a park.
  lawn,
  haloed_sky,
  park_sky,
  lawn_solid,
  plain_park_solid,
  park_solid,
  park_outline,
  park_shadow,
  land,
  land_drawing,
  plant,
  plant_shadow,
  contact,
  spray,
  water,
  lamp,
  lamp_streak
};
inline constexpr std::size_t kScenePrograms = static_cast<std::size_t>(SceneProgram::lamp_streak) + 1;

// Compiles each program when it is first used: few pictures use all, and Mesa takes some 70 ms for them.
class ScenePrograms {
 public:
  explicit ScenePrograms(const Gl& gl) : gl_(&gl) {}
  // Returns the program, in use. One that does not compile is empty and draws nothing.
  const ShaderProgram& use(SceneProgram name);
  // Code::graphics with the compiler's log of the first program that did not compile.
  const base::Status& failure() const { return failure_; }

 private:
  const Gl* gl_;
  std::array<std::optional<ShaderProgram>, kScenePrograms> programs_;
  base::Status failure_;
};

class SunShadows;

// Shared by all passes of one picture.
struct PassContext {
  const Gl& gl;
  ScenePrograms& programs;
  const Scene& scene;
  const SceneStyle& scenery;
  glm::mat4 view_projection;
  GLuint no_attributes;  // a vertex array without attributes
  DrawStats& stats;
  bool park = false;          // the scene has a land
  bool lit = false;           // lamps of a park shine
  glm::vec2 cast_heights{0};  // m, of a park: the lowest height that shadow maps tell apart, and their range

  // Returns the program, in use; an empty one if no pixels are drawn.
  const ShaderProgram& use(SceneProgram name) const {
    static const ShaderProgram kNone;
    return scene.unseen ? kNone : programs.use(name);
  }
  void count(std::int64_t triangles) const {
    ++stats.draw_calls;
    stats.triangles += triangles;
  }
};

// Texture units.
inline constexpr int kValueUnit = 0, kTrackShadowUnit = 1, kTrainShadowUnit = 3, kPaintUnit = 5, kGrainUnit = 6,
                     kLampUnit = 7;

// Lets the buffers of very long tracks hold in full what the view can show, from now on.
void choose_levels(const Scene& scene, TrackCache& track);
// From now on draws track with fewer triangles where a rail is at most two pixels wide, and without ties where these
// are less than a pixel apart.
void choose_detail(const Scene& scene, TrackCache& track);

// Draws sky, and ground with its shadows.
void draw_backdrop(const PassContext& pass, const SunShadows& shadows);
// Draws the sky of a park, behind all that is there.
void draw_sky_behind(const PassContext& pass);

// Draw track and trains into a shadow map; its texels are `texel_metres` wide.
void cast_track(const PassContext& pass, TrackCache& track, const glm::mat4& light, float texel_metres);
void cast_carts(const PassContext& pass, const CarInstances& instances, const glm::mat4& light);

// Returns where the headlight of a first car is (m).
glm::vec3 headlight_of(const sim::Pose& car);

// Draws track and trains; in the blueprint style their outlines first, so that they show behind them.
void draw_solids(const PassContext& pass, const TrackCache& track, const CarInstances& instances, ValueTexture& values,
                 SectionPaint& paint, const SunShadows& shadows);

// Draws the laboratory's polyline. `timer` measures its GPU time.
void draw_polyline(const PassContext& pass, const TrackCache& track, GpuCurves& curves, GpuTimer& timer);

// Draws lines and marks over everything.
void draw_overlay(const PassContext& pass, const CarInstances& instances);

}  // namespace coaster::gfx
