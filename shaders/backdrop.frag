// Sky and ground by the ray of each pixel: no geometry, so no far edge. The ground is the plane y = 0.
uniform vec3 eye;
uniform vec3 zenith, ground_colour, grid_light;  // the last is linear light, added where lines are
uniform float glow_strength;                     // of the sky around the sun
in vec3 direction;
out vec4 colour;

// Lines of `width` metres every `spacing` metres, antialiased by the pixel's footprint: where a line is thinner than a pixel it stays a
// pixel wide and pales instead; where the pattern is finer than pixels it becomes its mean.
float grid(vec2 place, vec2 footprint, float spacing, float width) {
  vec2 size = footprint / spacing;
  float target = width / spacing;
  vec2 drawn = clamp(vec2(target), size, vec2(0.5));
  vec2 blur = 1.5 * size;
  vec2 away = abs(fract(place / spacing - 0.5) - 0.5);
  vec2 line = 1.0 - smoothstep(0.5 * drawn - blur * 0.5, 0.5 * drawn + blur * 0.5, away);
  line *= clamp(target / drawn, 0.0, 1.0);
  line = mix(line, vec2(target), clamp(2.0 * size - 1.0, 0.0, 1.0));
  return mix(line.x, 1.0, line.y);
}

vec3 sky(vec3 sight) {
  float height = clamp(sight.y, 0.0, 1.0);
  float climb = 1.0 - exp(-3.0 * height * height / (height + 0.05));  // flat at the horizon, where it meets the fog without an edge
  vec3 light = mix(linear_of(horizon), linear_of(zenith), climb);
  float glow = max(dot(sight, normalize(vec3(kSun.x, 0.12, kSun.z))), 0.0);
  return light + glow_strength * vec3(0.07, 0.045, 0.01) * pow(glow, 6.0) * (1.0 - height);
}

void main() {
  vec3 sight = normalize(direction);
  float drop = sight.y < -1e-5 ? sight.y : -1e-5;
  float metres = max(eye.y, 0.0) / -drop;
  vec2 place = eye.xz + sight.xz * metres;
  vec2 footprint = abs(dFdx(place)) + abs(dFdy(place));  // before any branch: derivatives need their neighbours
  vec3 light = sky(sight);
  if (eye.y < 0.0) {
    light = mix(linear_of(vec3(0.36, 0.33, 0.29)), linear_of(vec3(0.52, 0.49, 0.43)), 0.5 + 0.5 * sight.y);  // inside the earth
  } else if (sight.y < 0.0) {
    vec3 ground = linear_of(ground_colour);
    float one = grid(place, footprint, 1.0, 0.025), ten = grid(place, footprint, 10.0, 0.09);
    ground += grid_light * (0.30 * one + 0.42 * ten);
    light = mix(ground, linear_of(horizon), fog(metres, eye.y));
  }
  colour = vec4(encode(light), 1.0);
}
