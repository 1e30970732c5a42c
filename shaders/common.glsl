// Put before every shader: light and air of the scene's style, and the step from linear light to the screen. All colours are linear light.
layout(std140) uniform Air {
  vec4 sun;           // unit, towards the sun; w: 1 for a drawing in place of light
  vec4 sun_light;     // w: strength of reflections
  vec4 sky_light;     // falls on what faces up; w: penumbra in metres for a metre of height
  vec4 ground_light;  // on what faces down; w: light of lamps, for each part of paint
  vec4 horizon;       // far air, away from the sun; w: metres in which fog grows thick
  vec4 haze;          // far air towards the sun; w: how narrow
  vec4 middle;        // of the sky; w: how much of clouds
  vec4 zenith;
  vec4 glow;          // around the sun; w: the sun's own
  vec4 hills;         // w: their height, as a tangent; without hills the far air's colour
  vec4 ground;        // paint; w: how uneven
  vec4 grid;          // paint of its lines; w: how much of it
  vec4 ink;           // lines of a drawing; w: how much of the ground's light a full shadow takes away
} air;
const float kHighest = 128.0;  // m over the ground: shadow maps tell no greater heights apart

// sRGB and back for 0..1, by roots in place of powers, which software renderers take long to compile and to compute: minimax fits that are off by at
// most a quarter of one of 255 steps of the screen.
vec3 linear_of(vec3 colour) {
  vec3 root = sqrt(colour);
  return colour * (0.0948205 - 0.2462515 * root + colour * (0.6949750 + 0.4546535 * root));
}
vec3 srgb_of(vec3 light) {
  vec3 root = sqrt(light);
  return mix(12.92 * light, 0.8337491 * root + 0.2981106 * sqrt(root) - 0.0553147 * light - 0.0769040, step(0.0031308, light));
}
// To the screen's sRGB. The shoulder keeps highlights below white and the toe shadows above black, as film does; a drawing's colours stay.
vec3 encode(vec3 light) {
  const float kShoulder = 0.58, kRoom = 0.38, kBlack = 0.0035;
  vec3 soft = min(light, kShoulder) + kRoom * (1.0 - exp(-max(light - kShoulder, 0.0) / kRoom));
  soft = mix(kBlack + (1.0 - kBlack) * soft, light, air.sun.w);
  return srgb_of(max(soft, 0.0));
}

// The air's colour far away in a direction.
vec3 far_air(vec3 sight) {
  float towards = 0.5 + 0.5 * dot(sight.xz, air.sun.xz) / max(length(sight.xz) * length(air.sun.xz), 1e-4);
  return mix(air.horizon.rgb, air.haze.rgb, pow(clamp(towards, 0.0, 1.0), air.haze.w));
}
// What far ground and solids fade into: the mist at the feet of the hills.
const float kFeet = 0.36;
vec3 mist(vec3 sight) { return mix(far_air(sight), air.hills.rgb, kFeet); }
// Powers, by products for the same reason.
float to_7(float x) {
  float square = x * x;
  return square * square * (square * x);
}
float to_90(float x) {
  float square = x * x, to_10 = square * square * (square * square) * square, to_30 = to_10 * to_10 * to_10;
  return to_30 * to_30 * to_30;
}
// Without the sun's disc; flat at the horizon, where it meets the fog without an edge.
vec3 sky(vec3 sight) {
  float height = clamp(sight.y, 0.0, 1.0);
  vec3 low = mix(far_air(sight), air.middle.rgb, 1.0 - exp(-9.0 * height * height / (height + 0.07)));
  float near = max(dot(sight, air.sun.xyz), 0.0);
  return mix(low, air.zenith.rgb, 1.0 - exp(-2.2 * height * height / (height + 0.25))) + air.glow.rgb * (0.16 * to_7(near) + 0.5 * to_90(near));
}
// How much of the air's colour covers what is `metres` away. An eye high up sees a large track whole: the air clears with height.
float fog(float metres, float eye_height) {
  float depth = metres / (air.horizon.w + 5.0 * max(eye_height, 0.0));
  return 1.0 - exp(-depth * sqrt(depth));
}

float random(ivec2 cell) {
  uint bits = uint(cell.x) * 1597334677u ^ uint(cell.y) * 3812015801u;
  bits = (bits ^ (bits >> 15)) * 2246822519u;
  return float(bits >> 8) / 16777216.0;
}
// Smooth noise of about -1 to 1 with cells of 1 m.
float noise(vec2 place) {
  ivec2 cell = ivec2(floor(place));
  vec2 t = fract(place);
  t = t * t * (3.0 - 2.0 * t);
  float a = random(cell), b = random(cell + ivec2(1, 0)), c = random(cell + ivec2(0, 1)), d = random(cell + ivec2(1, 1));
  return 2.0 * mix(mix(a, b, t.x), mix(c, d, t.x), t.y) - 1.0;
}
