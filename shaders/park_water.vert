// The water over the land's own triangles: level, and as deep as the land lies below it.
layout(location = 0) in vec3 from_corner;  // m
layout(location = 3) in vec2 baked;        // of the sun, and half of lamps
layout(location = 4) in float lift;        // m
layout(location = 5) in vec2 corner;       // m, of the patch
uniform mat4 view_projection;
uniform vec3 eye;
uniform float water;  // m
out vec3 world;
out float depth;              // m
out vec4 before;              // air, and its share
out vec3 horizon;             // distant air where the mirrored ray goes
out vec2 baked_light;         // sun, lamps
out vec2 track_at, train_at;  // in the shadow maps

void main() {
  vec3 position = from_corner + vec3(corner.x, lift, corner.y);
  world = vec3(position.x, water, position.z);
  depth = water - position.y;
  gl_Position = view_projection * vec4(world, 1.0);
  before = air_before(world, eye);
  vec3 sight = world - eye;
  horizon = far_air(normalize(vec3(sight.x, 0.0, sight.z) + vec3(1e-4, 0.0, 0.0)));
  baked_light = baked;
  track_at = (track_light * vec4(world, 1.0)).xy;
  train_at = (train_light * vec4(world, 1.0)).xy;
}
