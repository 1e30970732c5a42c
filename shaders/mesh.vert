// Track and trains; with SHADOW as seen from the sun, with OUTLINE grown by the width of the outline. One program for
// both, because compiling delays the first frame. The track has the unit matrix as its model; trains have no position
// along a segment.
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in float part;
layout(location = 3) in vec4 model_x;
layout(location = 4) in vec4 model_y;
layout(location = 5) in vec4 model_z;
layout(location = 6) in vec4 model_origin;
layout(location = 7) in vec2 place;
uniform mat4 view_projection;
#ifndef SHADOW
uniform vec3 eye;
uniform float least_width;  // radius of tubes in metres per metre of distance; 0: unchanged
uniform float outline;  // width of outlines, likewise, at most 6 cm
#endif
out vec3 world;
out vec3 facing;  // outwards
flat out float material;
out float along;  // fraction of the segment's length, 0..1
flat out float segment;    // index

void main() {
  mat4 model = mat4(model_x, model_y, model_z, model_origin);
  world = (model * vec4(position, 1.0)).xyz;
  facing = mat3(model) * normal;
  along = place.x;
  segment = place.y;
#ifndef SHADOW
  // Coloured rails stay visible at a distance. No part of a train is a rail or a spine.
  if (part < 1.5) world += normal * max(least_width * distance(world, eye) - (part < 0.5 ? 0.12 : 0.28), 0.0);
#endif
  material = part;
#ifdef OUTLINE
  world += normalize(facing) * min(outline * distance(world, eye), 0.06);
#endif
  gl_Position = view_projection * vec4(world, 1.0);
}
