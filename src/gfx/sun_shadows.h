// The shadow maps of a scene, one of the track and one of the trains: squares perpendicular to the sunlight over the
// shadow casters near the eye.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include <glm/glm.hpp>

#include "gfx/gl_objects.h"
#include "gfx/land_cache.h"
#include "gfx/passes.h"
#include "sim/ride/ride.h"
#include "sim/shape/derived_track.h"

namespace coaster::gfx {

// Axes of the light, unit and perpendicular: across (level), over (towards the sky), towards the sun.
struct SunAxes {
  glm::vec3 across{1, 0, 0}, over{0, 1, 0}, sun{0, 0, 1};
  explicit SunAxes(glm::vec3 towards_sun);
  glm::vec3 of(glm::vec3 world) const { return {glm::dot(world, across), glm::dot(world, over), glm::dot(world, sun)}; }
  glm::vec3 world(glm::vec3 light) const { return light.x * across + light.y * over + light.z * sun; }
};

// A box along the light's axes, metres; empty if low > high.
struct LightBox {
  glm::vec3 low{3e38f}, high{-3e38f};
  bool empty() const { return low.x > high.x; }
  void add(glm::vec3 light, float margin);
};
// The box of the track, of everything within sim::kSupportReach of it, and from there to the height `ground` (m).
class TrackBox {
 public:
  // Updates the box from the same DerivedTrack as before and returns it. Reads only the segments that
  // DerivedTrack::changes_since() lists, and the rest in runs of neighbours.
  const LightBox& update(const SunAxes& axes, const sim::DerivedTrack& derived, float ground = 0);
  std::size_t looked_at() const { return looked_at_; }  // segments read in the last update

 private:
  std::optional<glm::vec3> sun_;
  float ground_ = 0;
  std::uint64_t last_build_ = 0;
  std::vector<LightBox> runs_;  // of kRun segments each, in the track's order
  LightBox box_;
  std::size_t looked_at_ = 0;
};
inline constexpr float kCarMargin = 2.5f;  // m about the middle of a car's rails; more where riders hang
// Returns the box of the cars: the margin around their middles, more for longer cars.
LightBox light_box(const SunAxes& axes, std::span<const sim::Pose> carts, float margin = kCarMargin);

struct ShadowFit {
  glm::vec3 middle{0};  // along the light's axes
  float side = 0;       // m, side of the square, a power of two; 0: no casters
  float depth = 1;      // m, between the nearest and the farthest point from the sun
  friend bool operator==(const ShadowFit&, const ShadowFit&) = default;
};
// Returns the whole box if it fits into `least` metres (a power of two). For a larger box, the part around what `eye`
// sees, larger for higher and more distant eyes. The square moves in steps of an eighth of its side, so that texels
// stay aligned while the eye moves and the map stays valid for a while.
// `deeper`: m before and behind the box within which things cast and take shadows.
inline constexpr float kDepthMargin = 1;
ShadowFit fit_shadow(const SunAxes& axes, const LightBox& box, float least, glm::vec3 eye, glm::vec3 forward,
                     float deeper = kDepthMargin);

// Return the matrices from the world to OpenGL clip space, and to 0..1 in the map.
glm::mat4 clip_of(const SunAxes& axes, const ShadowFit& fit);
glm::mat4 map_of(const SunAxes& axes, const ShadowFit& fit);

// A picture of the track or the trains seen from the sun: depth, for shadows on solids, and coverage with mipmaps, for
// the ground, which is below everything and needs no depth.
class ShadowMap {
 public:
  explicit ShadowMap(const Gl& gl) : gl_(&gl) {}

  // Redraws the map if its size (texels per side), fit, light or `content` (a number that changes with the casters)
  // differ from the last time. `draw` gets the matrix to clip space, with state and target set. Leaves another
  // framebuffer bound. `unseen`: `draw` only counts, and the map is drawn with the next visible picture. Returns true
  // if the requested map differs from the last call's.
  bool update(int size, const SunAxes& axes, const ShadowFit& fit, std::uint64_t content, bool unseen,
              const std::function<void(const glm::mat4&)>& draw);

  // Binds the textures to units `unit` (depth) and `unit` + 1 (coverage), and sets PREFIX_depth, PREFIX_cover,
  // PREFIX_light and PREFIX_texel of the program in use. Call after update().
  void bind(const ShaderProgram& program, const char* prefix, int unit) const;
  // Returns false if the map shades nothing of a box.
  bool reaches(const Box& box) const;

 private:
  void make(int size);

  struct Key {
    int size = 0;
    glm::vec3 sun{0};
    ShadowFit fit;
    std::uint64_t content = 0;
    friend bool operator==(const Key&, const Key&) = default;
  };
  const Gl* gl_;
  GlObject framebuffer_, depth_, cover_;
  Key drawn_, wanted_;
  glm::mat4 to_map_{1};
};

// Redraws a map only if its casters, the light or the visible part of the scene changed.
class SunShadows {
 public:
  explicit SunShadows(const Gl& gl) : track_(gl), trains_(gl) {}
  // Counts the drawn maps in stats.shadow_maps. Call after updating `track` and `instances`; binds framebuffers.
  // `park`, if there is a land: draws what else casts shadows in the track's map, whose content it numbers.
  struct ParkCasters {
    std::uint64_t content = 0;
    float lowest = 0;  // m, of the land
    float half = 0;    // m, half the side of its square, which casts shadows while there is no track
    std::function<void(const glm::mat4& light)> draw;
  };
  void update(const PassContext& pass, TrackCache& track, const CarInstances& instances, const ParkCasters* park);
  // For the program in use.
  void bind(const ShaderProgram& program) const;
  const ShadowMap& track() const { return track_; }
  const ShadowMap& trains() const { return trains_; }

 private:
  ShadowMap track_, trains_;
  TrackBox track_box_;
  std::vector<sim::Pose> cars_;  // poses of the last `trains_` map
  world::CoasterKind kind_{};    // of those cars
  std::uint64_t cars_version_ = 1;
};

}  // namespace coaster::gfx
