// The appearance of sky, ground and light in each style, and the uniform block that passes it to the shaders.
#pragma once

#include <glm/glm.hpp>

#include "gfx/gl_objects.h"
#include "world/settings.h"

namespace coaster::gfx {

// Colours as shown on screen (sRGB, 0..1); lights are linear, 1: a surface shows its own colour.
struct SceneStyle {
  bool drawing = false;    // flat faces and outlines instead of light
  glm::vec3 sun{0, 1, 0};  // towards it; not necessarily unit
  glm::vec3 sun_light{1}, sky_light{0.4f}, ground_light{0.2f};
  float penumbra = 0;              // m of a shadow's soft edge per metre of height
  float reflections = 1;           // strength of reflections of sun and sky on varnished paint
  float lamps = 0;                 // light emitted by the train's stripe, 1: its colour
  glm::vec3 horizon{0}, haze{0};   // distant air away from the sun, and towards it
  float haze_width = 1;            // exponent: larger is narrower
  glm::vec3 middle{0}, zenith{0};  // of the sky
  bool night = false;              // stars, and lamps in a park
  float clouds = 0;                // fraction of the sky that clouds hide
  glm::vec3 glow{0};               // linear light around the sun
  float disc = 0;                  // brightness of the sun's disc
  float fog_metres = 480;          // distance of dense fog
  glm::vec3 hills{0};
  float hills_height = 0;   // tangent of the highest hill; 0: none
  glm::vec3 ground{0};      // as shown in sunlight
  float uneven = 0;         // unevenness, as a fraction of the ground's colour
  glm::vec3 grid{0};        // colour of the grid lines in sunlight
  float grid_strength = 0;  // 1: opaque
  float shade = 1;          // fraction of the sunlight that a full shadow removes on the ground
  glm::vec3 ink{0};         // outlines in the blueprint style
};

// Returns the row of a style: a summer day; a low warm sun under a violet sky; a blueprint for the laboratory and for
// print.
const SceneStyle& scenery_of(world::Style style);

// Returns the colour around the viewport: the panels' background, sRGB.
glm::vec3 around_of(world::Theme theme);

// The shaders' uniform block `Air` on the GPU, written if the style changes.
class SceneStyleBuffer {
 public:
  explicit SceneStyleBuffer(const Gl& gl) : gl_(&gl), buffer_(make_buffer(gl)) {}
  void bind(const SceneStyle& scenery);

 private:
  const Gl* gl_;
  GlObject buffer_;
  const SceneStyle* written_ = nullptr;  // rows of scenery_of() have static lifetime
};

}  // namespace coaster::gfx
