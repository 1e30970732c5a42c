// The sky with the sun and distant hills by the ray of each pixel; for an eye below the ground, the inside of the
// earth, which a blueprint draws in its own colour.
uniform vec3 eye;
uniform float pixel;  // its side at distance 1
in vec3 direction;
out vec4 colour;

// Two distant ridges, as tangents of their height: sums of waves around the horizon.
vec2 ridges(float turn) {
  float far = 0.62 + 0.22 * sin(3.0 * turn + 1.1) + 0.13 * sin(7.0 * turn + 4.0) + 0.06 * sin(17.0 * turn) +
              0.025 * sin(41.0 * turn + 2.0);
  float near = 0.34 + 0.16 * sin(4.0 * turn + 5.2) + 0.09 * sin(9.0 * turn + 0.7) + 0.05 * sin(23.0 * turn + 3.0) +
               0.02 * sin(53.0 * turn);
  return air.hills.w * vec2(far, near);
}

// Thin clouds, stretched by the wind, that end above the horizon.
float clouds(vec3 sight) {
  vec2 at = sight.xz / (sight.y + 0.14) * vec2(0.9, 2.1) + vec2(3.1, 7.7);
  float billows =
      0.5 * noise(at) + 0.27 * noise(at * 2.3 + 5.0) + 0.15 * noise(at * 5.1 + 11.0) + 0.08 * noise(at * 11.0 + 2.0);
  return air.middle.w * smoothstep(-0.05, 0.6, billows) * smoothstep(0.04, 0.3, sight.y);
}

// A point of light in some of the cells of a cube around the eye.
vec3 stars(vec3 sight) {
  vec3 at = 190.0 * sight;
  ivec3 cell = ivec3(floor(at));
  float lit = step(0.994, random(ivec2(cell.x + 517 * cell.z, cell.y)));
  vec3 from = fract(at) - 0.5;
  return lit * vec3(0.8, 0.85, 1.0) * smoothstep(0.16, 0.02, dot(from, from)) * smoothstep(0.02, 0.25, sight.y);
}

vec3 heavens(vec3 sight) {
  vec3 light = sky(sight);
  if (air.middle.w > 0.0) light = mix(light, 1.08 * far_air(sight), clouds(sight));
  light += air.glow.w * vec3(1.0, 0.93, 0.8) * smoothstep(0.99984, 0.99992, dot(sight, air.sun.xyz));
#ifdef HALO
  float halo = to_90(max(dot(sight, air.sun.xyz), 0.0)), halo_2 = halo * halo;
  light += air.glow.rgb * (0.55 * halo_2 + 0.9 * halo_2 * halo_2 * halo_2);
#endif
  for (int i = 0; i < int(air.zenith.w); ++i) light += stars(sight);
  if (air.hills.w <= 0.0) return light;
  float height = sight.y / max(length(sight.xz), 1e-4);
  vec2 ridge = ridges(atan(sight.z, sight.x));
  vec2 under = smoothstep(vec2(-1.0), vec2(1.0), (ridge - height) / pixel);
  // Mist at their feet, the same as over the distant ground.
  vec2 clear = mix(vec2(kFeet), vec2(0.46, 0.74), smoothstep(vec2(0.0), vec2(1.0), height / ridge));
  vec3 air_there = far_air(sight);
  light = mix(light, mix(air_there, air.hills.rgb, clear.x), under.x);
  return mix(light, mix(air_there, air.hills.rgb, clear.y), under.y);
}

void main() {
  vec3 sight = normalize(direction);
  vec3 earth = mix(linear_of(vec3(0.36, 0.33, 0.29)), linear_of(vec3(0.52, 0.49, 0.43)), 0.5 + 0.5 * sight.y);
  vec3 light = eye.y < 0.0 ? mix(earth, 0.75 * air.ground.rgb, air.sun.w) : heavens(sight);
  colour = vec4(encode(light), 1.0);
}
