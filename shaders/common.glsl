// Prepended to every shader: light and air of the scene's style, and the conversion from linear light to the screen.
// All colours are linear light.
layout(std140) uniform Air {
  vec4 sun;           // unit, towards the sun; w: 1 for the blueprint style
  vec4 sun_light;     // w: strength of reflections
  vec4 sky_light;     // on surfaces that face up; w: penumbra in metres per metre of height
  vec4 ground_light;  // on surfaces that face down; w: light of lamps, per part of paint
  vec4 horizon;       // distant air, away from the sun; w: distance of dense fog in metres
  vec4 haze;          // distant air towards the sun; w: its narrowness
  vec4 middle;        // of the sky; w: amount of clouds
  vec4 zenith;        // w: 1 if there are stars
  vec4 glow;          // around the sun; w: brightness of the sun's disc
  vec4 hills;         // w: their height, as a tangent; without hills the colour of distant air
  vec4 ground;        // paint; w: its unevenness
  vec4 grid;          // paint of its lines; w: their strength
  vec4 ink;           // outlines of the blueprint style; w: fraction of the ground's light that a full shadow removes
}
air;
const float kHighest = 128.0;  // m above the ground: shadow maps do not distinguish greater heights

// sRGB and back for 0..1, by roots instead of powers, which are slow to compile and compute in software renderers:
// minimax fits with an error of at most a quarter of one of the screen's 255 steps.
vec3 linear_of(vec3 colour) {
  vec3 root = sqrt(colour);
  return colour * (0.0948205 - 0.2462515 * root + colour * (0.6949750 + 0.4546535 * root));
}
vec3 srgb_of(vec3 light) {
  vec3 root = sqrt(light);
  return mix(12.92 * light, 0.8337491 * root + 0.2981106 * sqrt(root) - 0.0553147 * light - 0.0769040,
             step(0.0031308, light));
}
// Encodes to the screen's sRGB. The shoulder keeps highlights below white and the toe keeps shadows above black; the
// blueprint style keeps its colours.
vec3 encode(vec3 light) {
  const float kShoulder = 0.58, kRoom = 0.38, kBlack = 0.0035;
  vec3 soft = min(light, kShoulder) + kRoom * (1.0 - exp(-max(light - kShoulder, 0.0) / kRoom));
  soft = mix(kBlack + (1.0 - kBlack) * soft, light, air.sun.w);
  return srgb_of(max(soft, 0.0));
}

// Returns the colour of the distant air in a direction.
vec3 far_air(vec3 sight) {
  float towards = 0.5 + 0.5 * dot(sight.xz, air.sun.xz) / max(length(sight.xz) * length(air.sun.xz), 1e-4);
  return mix(air.horizon.rgb, air.haze.rgb, pow(clamp(towards, 0.0, 1.0), air.haze.w));
}
// The colour that distant ground and solids fade into: the mist at the feet of the hills.
const float kFeet = 0.36;
vec3 mist(vec3 sight) { return mix(far_air(sight), air.hills.rgb, kFeet); }
// Powers by products, for the same reason.
float to_7(float x) {
  float square = x * x;
  return square * square * (square * x);
}
float to_90(float x) {
  float square = x * x, to_10 = square * square * (square * square) * square, to_30 = to_10 * to_10 * to_10;
  return to_30 * to_30 * to_30;
}
// The sky without the sun's disc; uniform at the horizon, where it meets the fog without an edge.
vec3 sky(vec3 sight) {
  float height = clamp(sight.y, 0.0, 1.0);
  vec3 low = mix(far_air(sight), air.middle.rgb, 1.0 - exp(-9.0 * height * height / (height + 0.07)));
  float near = max(dot(sight, air.sun.xyz), 0.0);
  return mix(low, air.zenith.rgb, 1.0 - exp(-2.2 * height * height / (height + 0.25))) +
         air.glow.rgb * (0.16 * to_7(near) + 0.5 * to_90(near));
}
// Returns how much the air covers an object at `metres`. The air clears with the height of the eye, so a high eye sees
// a whole large track.
float fog(float metres, float eye_height) {
  float depth = metres / (air.horizon.w + 5.0 * max(eye_height, 0.0));
  return 1.0 - exp(-depth * sqrt(depth));
}

// The same in a park, by vertex: returns the light of the air before a place, times its share (w). Distances count
// less, so that hills and trees behind the track stay clear.
vec4 air_before(vec3 place, vec3 from) {
  vec3 sight = place - from;
  float metres = length(sight), much = 0.96 * fog(0.72 * metres, from.y);
  return vec4(mist(sight / max(metres, 1e-3)) * much, much);
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
  float a = random(cell), b = random(cell + ivec2(1, 0)), c = random(cell + ivec2(0, 1)),
        d = random(cell + ivec2(1, 1));
  return 2.0 * mix(mix(a, b, t.x), mix(c, d, t.x), t.y) - 1.0;
}
