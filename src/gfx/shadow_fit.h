// The area of a shadow map: a square perpendicular to the sunlight over the shadow casters near the eye. Pure
// functions, no GL.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include <glm/glm.hpp>

#include "sim/ride/ride.h"
#include "sim/shape/derived.h"

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
// The box of the track, of everything within sim::kSupportReach of it, and from there to the ground.
class TrackBox {
 public:
  // Updates the box from the same Derived as before and returns it. Reads only the segments that
  // Derived::changes_since() lists, and the rest in runs of neighbours.
  const LightBox& update(const SunAxes& axes, const sim::Derived& derived);
  std::size_t looked_at() const { return looked_at_; }  // segments read in the last update

 private:
  std::optional<glm::vec3> sun_;
  std::uint64_t last_build_ = 0;
  std::vector<LightBox> runs_;  // of kRun segments each, in the track's order
  LightBox box_;
  std::size_t looked_at_ = 0;
};
// Returns the box of the cars: 2.5 m around their middles, more for longer cars.
LightBox light_box(const SunAxes& axes, std::span<const sim::Pose> carts);

struct ShadowFit {
  glm::vec3 middle{0};  // along the light's axes
  float side = 0;       // m, side of the square, a power of two; 0: no casters
  float depth = 1;      // m, between the nearest and the farthest point from the sun
  friend bool operator==(const ShadowFit&, const ShadowFit&) = default;
};
// Returns the whole box if it fits into `least` metres (a power of two). For a larger box, the part around what `eye`
// sees, larger for higher and more distant eyes. The square moves in steps of an eighth of its side, so that texels
// stay aligned while the eye moves and the map stays valid for a while.
ShadowFit fit_shadow(const SunAxes& axes, const LightBox& box, float least, glm::vec3 eye, glm::vec3 forward);

// Return the matrices from the world to OpenGL clip space, and to 0..1 in the map.
glm::mat4 clip_of(const SunAxes& axes, const ShadowFit& fit);
glm::mat4 map_of(const SunAxes& axes, const ShadowFit& fit);

}  // namespace coaster::gfx
