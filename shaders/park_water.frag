// Water: waves, the sky mirrored by angle, glints, foam at shores, soft shadows. Blended over the land below it.
uniform vec3 eye;
uniform sampler2D grain;
uniform int track_taps, train_taps;
uniform float clock;  // s
uniform float waves;  // 1; 0: flat
in vec3 world, horizon;
in float depth;
in vec4 before;
in vec2 baked_light;
in vec2 track_at, train_at;
out vec4 colour;

float cover(sampler2D map, vec2 at) {
  vec2 edge = 0.5 - abs(at - 0.5);
  return clamp(25.0 * min(edge.x, edge.y), 0.0, 1.0) * texture(map, at, 2.0).r;
}

// The sky where a mirrored ray goes: that of common.glsl, with the distant air found by vertex and without the glow.
vec3 mirrored_sky(float height) {
  vec3 low = mix(horizon, air.middle.rgb, 1.0 - exp(-9.0 * height * height / (height + 0.07)));
  return mix(low, air.zenith.rgb, 1.0 - exp(-2.2 * height * height / (height + 0.25)));
}

void main() {
  vec3 to_eye = eye - world;
  float metres = length(to_eye);
  to_eye /= metres;
  vec2 swell = waves * (texture(grain, world.xz / 13.0 + vec2(0.020, 0.013) * clock).rg +
                        texture(grain, world.zx / 7.3 - vec2(0.017, 0.022) * clock).gr - 1.0);
  float calm = 1.0 / (1.0 + metres / 90.0);
  vec3 normal = normalize(vec3(0.20 * swell.x * calm, 1.0, 0.20 * swell.y * calm));
  vec3 mirror = reflect(-to_eye, normal);
  vec2 ripple = 0.7 * swell;  // m by which waves displace shadows
  float sun = baked_light.x;
  for (int i = 0; i < track_taps; ++i)
    sun *= 1.0 - 0.85 * cover(track_cover, track_at + ripple * track_texel.y / track_texel.x);
  for (int i = 0; i < train_taps; ++i)
    sun *= 1.0 - 0.85 * cover(train_cover, train_at + ripple * train_texel.y / train_texel.x);
  vec3 sunlight = air.sun_light.rgb * sun, over = air.sky_light.rgb + sunlight * air.sun.y;
  vec3 seen = mirrored_sky(max(mirror.y, 0.0));
  seen = mix(seen, vec3(0.045, 0.070, 0.035) * (air.sky_light.rgb + 0.5 * air.sun_light.rgb),
             0.6 * (1.0 - smoothstep(0.01, 0.13, mirror.y)));
  float away = 1.0 - max(dot(normal, to_eye), 0.0), away_2 = away * away;
  float fresnel = 0.02 + 0.98 * away_2 * away_2 * away;
  vec3 body = mix(vec3(0.055, 0.190, 0.170), vec3(0.016, 0.098, 0.118), 1.0 - exp(-0.45 * max(depth, 0.0))) *
              (air.sky_light.rgb + air.sun_light.rgb * air.sun.y * (0.45 + 0.55 * sun));
  body *= 1.0 + 0.16 * (swell.x + swell.y);
  vec3 light = mix(body, seen, fresnel);
  light += 0.5 * baked_light.y * vec3(1.0, 0.62, 0.30) * (0.06 + 0.3 * fresnel);
  // Of gentler waves than the mirror's: a path of light towards the sun, not a field of sparks.
  vec3 gentle = normalize(vec3(0.45 * normal.x, 1.0, 0.45 * normal.z));
  float towards = max(dot(gentle, normalize(air.sun.xyz + to_eye)), 0.0), glint = to_90(towards),
        flat_2 = towards * towards;
  light += waves > 0.0 ? sunlight * 2.0 * glint * glint : sunlight * 2.2 * glint * flat_2 * flat_2 * flat_2 * flat_2;
  float foam = 0.40 * waves * (1.0 - smoothstep(0.0, 0.20, depth + 0.22 * swell.x));
  light = mix(light, 0.8 * over, foam);
  float alpha = max(mix(0.30, 0.94, 1.0 - exp(-1.1 * max(depth, 0.0))), max(fresnel, foam));
  alpha *= smoothstep(-0.05, 0.06, depth);
  colour = vec4(encode(light * (1.0 - before.w) + before.rgb), alpha);
}
