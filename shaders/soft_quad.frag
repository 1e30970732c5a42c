// A shadow, darkest in the middle; with SPRAY drops that rise and fall behind a car.
in vec2 corner;
flat in vec4 soft;  // x: strength; y, z: part of each half that is not soft; of spray y: 1 to 0 as it rises, z: seed
in float clear;
out vec4 colour;
#ifdef SPRAY
uniform float clock;  // s
#endif

void main() {
#ifdef SPRAY
  vec2 at = 0.5 + 0.5 * corner;  // from the car backwards, and up
  float drops = 0.5 + 0.25 * noise(vec2(9.0 * at.x - 11.0 * clock, 6.0 * at.y - 5.0 * clock) + soft.z) +
                0.25 * noise(vec2(31.0 * at.x - 30.0 * clock, 19.0 * at.y - 13.0 * clock) + soft.z);
  float arc = 3.4 * at.x * (1.0 - at.x) * (1.0 - 0.35 * at.x);
  float alpha = soft.x * smoothstep(0.0, 0.45, arc * (0.55 + 0.8 * drops) - at.y) * smoothstep(0.15, 0.65, drops);
  vec3 light = 0.75 * air.sky_light.rgb + 0.45 * air.sun_light.rgb;
  colour = vec4(encode(light), alpha * clear);
#else
  vec2 fade = 1.0 - smoothstep(soft.yz, vec2(1.0), abs(corner));
  colour = vec4(0.0, 0.0, 0.0, soft.x * fade.x * fade.y * clear);
#endif
}
