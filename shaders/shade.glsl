// What the sun does not reach, after common.glsl: the maps that gfx/sun_shadows draws, one of the track and one of the trains.
uniform mat4 track_light, train_light;        // world to 0..1: place in the map and depth
uniform vec2 track_texel, train_texel;        // a texel's side in metres, and as a part of the map
uniform highp sampler2DShadow track_depth, train_depth;
uniform sampler2D track_cover, train_cover;   // r: how much of a texel is covered, g: times the height of what covers it, in kHighest

// How much of the light is taken from a place on the ground, by a map's mipmaps: over a pixel's footprint, drawn out along it, and over the
// penumbra, which grows with the height of what throws the shadow. x and y: the pixel's sides in metres; all in the map's plane.
float cover_at(sampler2D cover, mat4 to_map, vec2 texel, vec2 place, vec2 x, vec2 y) {
  vec2 at = (to_map * vec4(place.x, 0.0, place.y, 1.0)).xy;
  mat2 flat_part = mat2(to_map[0].xy, to_map[2].xy);
  vec2 side_x = flat_part * x, side_y = flat_part * y;
  vec2 edge = 0.5 - abs(at - 0.5);
  if (min(edge.x, edge.y) <= 0.0) return 0.0;
  bool wide = dot(side_x, side_x) > dot(side_y, side_y);
  vec2 major = wide ? side_x : side_y, minor = wide ? side_y : side_x;
  float per_metre = texel.y / texel.x, size = 1.0 / texel.y;
  float reach = max(length(major), 1.5 * per_metre);
  vec2 coarse = textureLod(cover, at, log2(reach * size)).rg;
  if (coarse.r <= 0.0) return 0.0;
  float soft = max((0.04 + air.sky_light.w * kHighest * coarse.g / coarse.r) * per_metre, 1.3 * texel.y);
  float level = log2(max(max(length(minor), 0.3 * length(major)), max(0.55 * soft, texel.y)) * size);
  float sum = 0.0;
  for (int i = 0; i < 4; ++i) {
    vec2 corner = vec2(float(i & 1), float(i >> 1)) - 0.5;
    float step_along = (float(i) - 1.5) * 0.25;
    sum += textureLod(cover, at + 0.62 * soft * corner + step_along * major, level).r;
  }
  return 0.25 * sum * smoothstep(0.0, 0.04, min(edge.x, edge.y));
}

float ground_shadow(vec2 place, vec2 x, vec2 y) {
  return max(cover_at(track_cover, track_light, track_texel, place, x, y), cover_at(train_cover, train_light, train_texel, place, x, y));
}

// How much of the sun reaches a place of a solid with a normal: depths compared, over about two texels.
float reached(highp sampler2DShadow depth, mat4 to_map, vec2 texel, vec3 world, vec3 normal) {
  // Off the surface by a texel, so that it does not shade itself; the map holds the far sides of what throws shadows.
  vec3 at = (to_map * vec4(world + (0.6 * texel.x) * normal + (0.25 * texel.x) * air.sun.xyz, 1.0)).xyz;
  vec3 edge = 0.5 - abs(at - 0.5);
  if (min(min(edge.x, edge.y), edge.z) <= 0.0) return 1.0;
  float sum = 0.0;
  for (int i = 0; i < 4; ++i) {
    vec2 corner = vec2(float(i & 1), float(i >> 1)) - 0.5;
    sum += texture(depth, vec3(at.xy + 1.2 * texel.y * corner, at.z));
  }
  return 0.25 * sum;
}

float sun_reaches(vec3 world, vec3 normal) {
  if (world.y < 0.0) return 1.0;
  return min(reached(track_depth, track_light, track_texel, world, normal), reached(train_depth, train_light, train_texel, world, normal));
}
