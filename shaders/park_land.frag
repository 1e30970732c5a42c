// The land: grain, shadows of track and trains, tone. With BLUEPRINT contour lines.
uniform sampler2D grain;             // r: coarse, g: fine
uniform int track_taps, train_taps;  // 1 where the map may shade this patch, else 0: skips a loop
uniform vec2 cast_heights;           // m, the lowest that a map distinguishes, and its range
in vec3 shaded, sunny, before;
in float facing;
in vec3 place;
#ifdef BLUEPRINT
in float height;
#endif
in vec3 track_at, train_at;
out vec4 colour;

// How much a map shades a point: by casters higher than this point alone.
float cover(sampler2D map, vec3 at) {
  vec2 there = texture(map, at.xy, 0.6).rg;
  vec2 edge = 0.5 - abs(at.xy - 0.5);
  float inside = clamp(25.0 * min(edge.x, edge.y), 0.0, 1.0);
  float above = cast_heights.x + cast_heights.y * there.g / max(there.r, 0.004) - at.z;
  return inside * there.r * clamp(2.0 * above - 0.3, 0.0, 1.0);
}

void main() {
#ifdef BLUEPRINT
  // Every two metres, and stronger every ten; level ground has none.
  float steep = fwidth(height), at = height + 1.0;
  float two = abs(fract(0.5 * at + 0.5) - 0.5) / max(0.5 * steep, 1e-5),
        ten = abs(fract(0.1 * at + 0.5) - 0.5) / max(0.1 * steep, 1e-5);
  float line = max(0.55 * (1.0 - smoothstep(0.4, 1.2, two)) * (1.0 - smoothstep(0.2, 0.8, steep)),
                   (1.0 - smoothstep(0.6, 1.5, ten)) * (1.0 - smoothstep(1.0, 4.0, steep)));
  line *= smoothstep(0.0, 0.004, steep);
  colour = vec4(encode(mix(air.ground.rgb, air.grid.rgb, air.grid.w * line)), 1.0);
#else
  vec2 rough = mix(vec2(0.5), texture(grain, place.xy).rg, place.z);
  float shade = 0.0;
  for (int i = 0; i < track_taps; ++i) shade = cover(track_cover, track_at);
  for (int i = 0; i < train_taps; ++i) shade = max(shade, cover(train_cover, train_at));
  float slope = facing + 0.55 * dot(rough.gr - 0.5, air.sun.xz);
  vec3 light = shaded + sunny * (max(slope, 0.0) * (1.0 - shade));
  colour = vec4(encode(light * ((0.62 + 0.76 * rough.r) * (0.7 + 0.6 * rough.g)) + before), 1.0);
#endif
}
