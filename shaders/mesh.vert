// Track and trains; with SHADOW as seen from the sun, with OUTLINE grown by the width of the outline. One program for
// all, because compiling delays the first frame. Rails, spine and ties are instances between two rings, each with axes
// and origin of its own; they have x = 0. Cars and couplings are instances with one set of axes; other solids have the
// unit axes. Trains have no position along a segment.
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in float part;
layout(location = 3) in vec3 model_x;
layout(location = 4) in vec3 model_y;
layout(location = 5) in vec3 model_z;
layout(location = 6) in vec3 model_origin;
layout(location = 7) in vec2 place;   // along and index of the segment; of other solids x is the hidden part of the sky
layout(location = 8) in vec3 next_y;  // of the second ring
layout(location = 9) in vec3 next_z;
layout(location = 10) in vec3 next_origin;
layout(location = 11) in float next_along;
layout(location = 12) in float end;  // 1: the vertex belongs to the second ring; -1: the solid is not swept
uniform mat4 view_projection;
#ifndef SHADOW
uniform vec3 eye;
uniform float least_width;  // radius of tubes in metres per metre of distance; 0: unchanged
uniform float outline;      // width of outlines, likewise, at most 6 cm
#endif
out vec3 world;
out vec3 facing;  // outwards
flat out float material;
out float along;         // fraction of the segment's length, 0..1
flat out float segment;  // index
#ifdef SHADED
out float hidden;  // part of the sky; at most 1, below 0: none
#endif

void main() {
  bool second = end > 0.5;
  mat3 axes = mat3(model_x, second ? next_y : model_y, second ? next_z : model_z);
  world = axes * position + (second ? next_origin : model_origin);
  facing = axes * normal;
  along = second ? next_along : place.x;
  segment = place.y;
#ifdef SHADED
  // Ties and spine darken each other and the lower sides of rails.
  hidden = end < -0.5 ? place.x : part < 0.5 ? -0.8 * normal.y : 0.5 - 0.3 * normal.y;
#endif
#ifndef SHADOW
  // Coloured rails stay visible at a distance. No part of a train is a rail or a spine.
  if (part < 1.5) world += facing * max(least_width * distance(world, eye) - (part < 0.5 ? 0.12 : 0.28), 0.0);
#endif
  material = part;
#ifdef OUTLINE
  // Empty instances face nowhere.
  world += facing / max(length(facing), 1e-6) * min(outline * distance(world, eye), 0.06);
#endif
  gl_Position = view_projection * vec4(world, 1.0);
}
