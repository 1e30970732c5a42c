// Where a shadow map lies: a square across the sunlight over what throws shadows, near the eye. Pure functions, no GL.
#pragma once

#include <span>

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

// A box along the light's axes, metres; empty when low > high.
struct LightBox {
  glm::vec3 low{3e38f}, high{-3e38f};
  bool empty() const { return low.x > high.x; }
  void add(glm::vec3 light, float margin);
};
// Of the track, what stands within sim::kSupportReach of it, and from there to the ground. O(segments).
LightBox light_box(const SunAxes& axes, const sim::Derived& derived);
// Of the cars, 2.5 m about their middles and as much as they are longer.
LightBox light_box(const SunAxes& axes, std::span<const sim::Pose> carts);

struct ShadowFit {
  glm::vec3 middle{0};  // along the light's axes
  float side = 0;       // m of the square, a power of two; 0: nothing throws shadows
  float depth = 1;      // m, from the nearest to the farthest from the sun
  friend bool operator==(const ShadowFit&, const ShadowFit&) = default;
};
// The whole box when it fits `least` metres (a power of two). Of a larger one the part about what `eye` sees, the
// larger the higher and the farther off the eye is. The square moves in steps of an eighth of its side, so that texels
// stay where they are while the eye moves, and what is drawn into the map keeps for a while.
ShadowFit fit_shadow(const SunAxes& axes, const LightBox& box, float least, glm::vec3 eye, glm::vec3 forward);

// World to OpenGL clip space, and to 0..1 in the map.
glm::mat4 clip_of(const SunAxes& axes, const ShadowFit& fit);
glm::mat4 map_of(const SunAxes& axes, const ShadowFit& fit);

}  // namespace coaster::gfx
