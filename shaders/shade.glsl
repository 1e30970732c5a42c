// Shadows of the sun, after common.glsl: reads the maps of gfx/sun_shadows, one of the track and one of the trains.
uniform mat4 track_light, train_light;  // world to 0..1: position in the map, and depth
uniform vec2 track_texel, train_texel;  // a texel's side in metres, and as a fraction of the map
uniform highp sampler2DShadow track_depth, train_depth;
uniform sampler2D track_cover, train_cover;  // r: coverage of a texel, g: times the height of the caster, in kHighest
uniform int taps;  // 4; a uniform, so that loops stay loops, which keeps compilers of software renderers fast

// A map around a point on the ground: the position in the map, the two sides of a pixel (m) there, and the mipmap level
// about as coarse as the pixel, or as a metre and a half.
struct Spot {
  vec2 at, major, minor;
  float level, inside;  // inside: 1, falling to 0 at the map's edges
};
Spot spot(mat4 to_map, vec2 texel, vec2 place, vec2 x, vec2 y) {
  Spot spot;
  spot.at = (to_map * vec4(place.x, 0.0, place.y, 1.0)).xy;
  mat2 flat_part = mat2(to_map[0].xy, to_map[2].xy);
  vec2 side_x = flat_part * x, side_y = flat_part * y;
  bool wide = dot(side_x, side_x) > dot(side_y, side_y);
  spot.major = wide ? side_x : side_y;
  spot.minor = wide ? side_y : side_x;
  spot.level = ceil(log2(max(length(spot.major) / texel.y, 1.6 / texel.x)));
  vec2 edge = 0.5 - abs(spot.at - 0.5);
  spot.inside = clamp(25.0 * min(edge.x, edge.y), 0.0, 1.0);
  return spot;
}

// Returns whether there may be a shadow at a point; fast.
bool maybe_shaded(vec2 place, vec2 x, vec2 y) {
  Spot track = spot(track_light, track_texel, place, x, y), train = spot(train_light, train_texel, place, x, y);
  return track.inside * textureLod(track_cover, track.at, track.level).r +
             train.inside * textureLod(train_cover, train.at, train.level).r >
         0.0;
}

// Returns the fraction of light removed from a point on the ground: coverage over a pixel's footprint, stretched along
// it, and over the penumbra, which grows with the height of the caster.
float cover_at(sampler2D cover, vec2 texel, Spot spot) {
  vec2 coarse = textureLod(cover, spot.at, spot.level).rg;
  float metre = texel.y / texel.x;
  float soft = max((0.04 + air.sky_light.w * kHighest * coarse.g / max(coarse.r, 0.003)) * metre, 1.3 * texel.y);
  float level = log2(max(max(length(spot.minor), 0.3 * length(spot.major)), max(0.55 * soft, texel.y)) / texel.y);
  float sum = 0.0;
  for (int i = 0; i < taps; ++i) {
    vec2 corner = vec2(float(i & 1), float(i >> 1)) - 0.5;
    sum += textureLod(cover, spot.at + 0.62 * soft * corner + (0.25 * float(i) - 0.375) * spot.major, level).r;
  }
  float covered = 0.25 * sum;
  float far = clamp(0.25 * length(spot.major) / texel.y, 0.0, 1.0);
  return spot.inside * covered *
         (1.0 + 0.6 * far * (1.0 - covered));  // thin distant rails remain visible by their shadow
}
float ground_shadow(vec2 place, vec2 x, vec2 y) {
  float track = cover_at(track_cover, track_texel, spot(track_light, track_texel, place, x, y));
  float train = cover_at(train_cover, train_texel, spot(train_light, train_texel, place, x, y));
  return max(track, train);
}

// Returns the fraction of sunlight at a point of a solid with a normal: depth comparison over about two texels.
float reached(highp sampler2DShadow depth, mat4 to_map, vec2 texel, vec3 world, vec3 normal) {
  // Offset from the surface by a texel, so that it does not shade itself; the map holds the far sides of casters.
  float away = 0.6;
#ifdef PARK
  away += 1.4 - 1.4 * max(dot(normal, air.sun.xyz), 0.0);  // more where the sun meets it at an angle
#endif
  vec3 at = (to_map * vec4(world + (away * texel.x) * normal + (0.25 * texel.x) * air.sun.xyz, 1.0)).xyz;
  vec2 edge = 0.5 - abs(at.xy - 0.5);
  if (min(min(edge.x, edge.y), at.z) <= 0.0) return 1.0;
  at.z = min(at.z, 1.0);  // beyond the map's depth everything in it is nearer to the sun
  float sum = 0.0;
  for (int i = 0; i < taps; ++i) {
    vec2 corner = vec2(float(i & 1), float(i >> 1)) - 0.5;
    sum += textureLod(depth, vec3(at.xy + 1.7 * texel.y * corner, at.z), 0.0);
  }
  return 0.25 * sum;
}

float sun_reaches(vec3 world, vec3 normal) {
#ifndef PARK
  if (world.y < 0.0) return 1.0;
#endif
  return min(reached(track_depth, track_light, track_texel, world, normal),
             reached(train_depth, train_light, train_texel, world, normal));
}
