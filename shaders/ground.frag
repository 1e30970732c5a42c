// The plane y = 0 by the ray of each pixel: no geometry, so no far edge. Its depth marks where ground_shadow.frag must
// run. With NO_GRID a lawn without lines.
uniform vec3 eye;                // above it
uniform vec3 eye_right, eye_up;  // of an orthographic view: from its middle to its edges; else 0
in vec3 direction;
in vec2 across;
out vec4 colour;

// Returns how much of lines of `width` metres every `spacing` metres a pixel shows. Lines thinner than a pixel stay a
// pixel wide and fade; a pattern finer than a few pixels vanishes before it could shimmer.
float grid(vec2 place, vec2 footprint, float spacing, float width) {
  vec2 size = footprint / spacing;
  float target = width / spacing;
  vec2 drawn = clamp(vec2(target), size, vec2(0.5));
  vec2 blur = 1.5 * size;
  vec2 away = abs(fract(place / spacing - 0.5) - 0.5);
  vec2 line = 1.0 - smoothstep(0.5 * drawn - blur * 0.5, 0.5 * drawn + blur * 0.5, away);
  line *= clamp(target / drawn, 0.0, 1.0) * (1.0 - smoothstep(0.12, 0.45, size));
  return line.x + line.y - line.x * line.y;
}

vec3 ground_paint(vec2 place, vec2 footprint) {
  float width = max(footprint.x, footprint.y);
  float uneven = 0.6 * noise(place / 37.0) + 0.4 * noise(place / 9.0 + 17.0) * (1.0 - smoothstep(3.0, 9.0, width));
  vec3 paint = air.ground.rgb * (1.0 + air.ground.w * uneven);
#ifdef NO_GRID
  return paint;
#else
  float one = grid(place, footprint, 1.0, 0.03), ten = grid(place, footprint, 10.0, 0.1);
  return mix(paint, air.grid.rgb, air.grid.w * max(0.36 * one, ten));
#endif
}

void main() {
  vec3 sight = normalize(direction);
  float metres = eye.y / max(-sight.y, 1e-5);
  vec2 place = eye.xz + across.x * eye_right.xz + across.y * eye_up.xz + sight.xz * metres;
  vec2 along_x = dFdx(place), along_y = dFdy(place);
  vec3 light = ground_paint(place, abs(along_x) + abs(along_y)) *
               mix(air.sun_light.rgb * air.sun.y + air.sky_light.rgb, vec3(1.0), air.sun.w);
  colour = vec4(encode(mix(light, mist(sight), fog(metres, eye.y))), 1.0);
  gl_FragDepth = maybe_shaded(place, along_x, along_y) ? 0.5 : 1.0;
}
