// The land, with its light by vertex: only grain, the shadows of track and trains, and the tone curve are left to
// pixels.
layout(location = 0) in vec3 from_corner;  // m
layout(location = 1) in vec4 normal;
layout(location = 2) in vec4 paint;   // square roots of linear light; a: ambient light
layout(location = 3) in vec2 baked;   // of the sun, and half of lamps
layout(location = 4) in float lift;   // m
layout(location = 5) in vec2 corner;  // m, of the patch
uniform mat4 view_projection;
uniform vec3 eye;
uniform float water;  // m
out vec3 shaded;      // light without the sun, behind the air
out vec3 sunny;       // what the sun adds where it meets the land at a right angle
out vec3 before;      // light of the air
out float facing;     // cosine between normal and sun
out vec3 place;       // of the grain; z: how much of it shows
#ifdef BLUEPRINT
out float height;  // m over the water
#endif
out vec3 track_at, train_at;  // in the shadow maps; z: height

void main() {
  vec3 position = from_corner + vec3(corner.x, lift, corner.y);
  gl_Position = view_projection * vec4(position, 1.0);
  vec3 own = paint.rgb * paint.rgb;
  float depth = max(water - position.y, 0.0);
  own *= exp(-0.55 * depth * vec3(1.3, 0.6, 0.5));
  vec4 air_here = air_before(position, eye);
  own *= 1.0 - air_here.w;
  vec3 ambient = mix(air.ground_light.rgb, air.sky_light.rgb, 0.5 + 0.5 * normal.y) * paint.a;
  shaded = own * (ambient + 2.0 * baked.y * vec3(1.0, 0.62, 0.30));
  sunny = own * air.sun_light.rgb * baked.x;
  before = air_here.rgb;
  facing = dot(normal.xyz, air.sun.xyz);
  place = vec3(position.xz / 11.0, 1.0 - 0.7 * smoothstep(60.0, 260.0, distance(position, eye)));
#ifdef BLUEPRINT
  height = position.y;
#endif
  track_at = vec3((track_light * vec4(position, 1.0)).xy, position.y);
  train_at = vec3((train_light * vec4(position, 1.0)).xy, position.y);
}
