// What a style makes of sky, ground and light, and how the shaders get it.
#pragma once

#include <glm/glm.hpp>

#include "gfx/objects.h"
#include "world/settings.h"

namespace coaster::gfx {

// Colours as they look on the screen (sRGB, 0..1); lights are linear, 1: a surface shows its own colour.
struct Scenery {
  bool drawing = false;    // flat faces and lines in place of light
  glm::vec3 sun{0, 1, 0};  // towards it; not necessarily unit
  glm::vec3 sun_light{1}, sky_light{0.4f}, ground_light{0.2f};
  float penumbra = 0;              // m of a shadow's soft edge for a metre of height
  float reflections = 1;           // of sun and sky on varnish
  float lamps = 0;                 // light of its own that the train's stripe gives, 1: its colour
  glm::vec3 horizon{0}, haze{0};   // far air away from the sun, and towards it
  float haze_width = 1;            // exponent: larger is narrower
  glm::vec3 middle{0}, zenith{0};  // of the sky
  float clouds = 0;                // how much of the sky behind them they hide
  glm::vec3 glow{0};               // linear light round the sun
  float disc = 0;                  // the sun's own
  float fog_metres = 480;          // where fog grows thick
  glm::vec3 hills{0};
  float hills_height = 0;   // tangent of the highest; 0: none
  glm::vec3 ground{0};      // as it looks in the sun
  float uneven = 0;         // of the ground's colour, a part of it
  glm::vec3 grid{0};        // the colour of its lines in the sun
  float grid_strength = 0;  // 1: opaque
  float shade = 1;          // how much of the sun a full shadow takes away on the ground
  glm::vec3 ink{0};         // lines of a drawing
};

// By world::Style: a summer's day; a low warm sun under a violet sky; a drawing for the laboratory and for print.
const Scenery& scenery_of(world::Style style);

// Beside the viewport: the panels' background, sRGB.
glm::vec3 around_of(world::Theme theme);

// As the shaders' uniform block `Air` has it (shaders/common.glsl): linear light, 16 bytes a member. Blocks read
// binding 0 unless told.
inline constexpr GLuint kAirBinding = 0;
struct Air {
  glm::vec4 sun, sun_light, sky_light, ground_light, horizon, haze, middle, zenith, glow, hills, ground, grid, ink;
};
Air air_of(const Scenery& scenery);

// The block on the GPU, written when the style changes.
class AirBuffer {
 public:
  explicit AirBuffer(const Gl& gl) : gl_(&gl), buffer_(make_buffer(gl)) {}
  void bind(const Scenery& scenery);

 private:
  const Gl* gl_;
  Object buffer_;
  const Scenery* written_ = nullptr;  // rows of scenery_of() outlive everything
};

}  // namespace coaster::gfx
