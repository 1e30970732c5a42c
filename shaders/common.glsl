// Put before every shader: the palette, light, air and the step from linear light to the screen.
// Colours are written as they look (sRGB, 0..1) and are linear light from linear_of() to encode(); gamma 2.2 stands for sRGB.
const vec3 kSun = vec3(0.4216, 0.7792, 0.4638);  // unit, towards the sun: warm light from one side, 51 degrees high
const vec3 kSunLight = vec3(1.06, 0.97, 0.82);
const vec3 kSkyLight = vec3(0.40, 0.47, 0.58);    // from above
const vec3 kGroundLight = vec3(0.20, 0.22, 0.17);  // bounced from below
uniform vec3 horizon;  // the air's colour far away

vec3 linear_of(vec3 colour) { return pow(colour, vec3(2.2)); }
// The shoulder keeps highlights below white.
vec3 encode(vec3 light) {
  vec3 soft = mix(light, 1.0 - 0.22 * exp(-(light - 0.78) / 0.22), step(0.78, light));
  return pow(max(soft, vec3(0.0)), vec3(1.0 / 2.2));
}
// How much of the air's colour covers what is `metres` away. An eye high up sees a large track whole: the air clears with height.
float fog(float metres, float eye_height) {
  float depth = metres / (480.0 + 5.0 * max(eye_height, 0.0));
  return 1.0 - exp(-depth * sqrt(depth));
}
