// Warm sun and sky on painted steel; what lies on the other side of the ground than the eye is hidden by it.
uniform vec3 eye;
uniform int colouring;        // 1: rails and spine by the segment's values
uniform sampler2D values;     // 32 a segment, uniform in arc length; 32 segments a row; over 1e38: unknown
uniform vec2 value_range;     // from and to
uniform vec3 stops[10];       // the colour map, uniform from 0 to 1
uniform vec3 unknown;
uniform float lift;           // of painted parts, 1 by day
in vec3 world;
in vec3 facing;
flat in float material;
in float along;
flat in float segment;
out vec4 colour;

// By sim::Part: rail, spine, tie, body, stripe, wheel.
vec3 paint(int part) {
  if (part == 0) return vec3(0.851, 0.271, 0.184);
  if (part == 1) return vec3(0.659, 0.204, 0.149);
  if (part == 2) return vec3(0.227, 0.247, 0.278);
  if (part == 3) return vec3(0.180, 0.369, 0.667);
  if (part == 4) return vec3(0.957, 0.773, 0.259);
  return vec3(0.15, 0.16, 0.18);
}

vec3 value_colour() {
  int index = int(segment + 0.5);
  float at = clamp(along, 0.0, 1.0) * 31.0;
  int first = min(int(at), 30);
  ivec2 texel = ivec2((index & 31) * 32 + first, index >> 5);
  float a = texelFetch(values, texel, 0).r, b = texelFetch(values, texel + ivec2(1, 0), 0).r;
  if (a > 1e38 && b > 1e38) return unknown;
  float value = a > 1e38 ? b : b > 1e38 ? a : mix(a, b, at - float(first));
  float part = clamp((value - value_range.x) / (value_range.y - value_range.x), 0.0, 1.0) * 9.0;
  int stop = min(int(part), 8);
  return mix(stops[stop], stops[stop + 1], part - float(stop));
}

void main() {
  if (world.y * eye.y < 0.0) discard;
  int part = int(material + 0.5);
  vec3 normal = normalize(facing), to_eye = eye - world;
  float metres = length(to_eye);
  to_eye /= metres;
  float sun = max(dot(normal, kSun), 0.0);
  vec3 ambient = mix(kGroundLight, kSkyLight, 0.5 + 0.5 * normal.y);
  bool by_value = colouring == 1 && part < 2;
  // Where colours are numbers, light only models: they stay near those of the legend.
  vec3 light = by_value ? linear_of(value_colour()) * (0.72 + 0.34 * sun + 0.12 * normal.y)
                        : lift * linear_of(paint(part)) * (kSunLight * sun + ambient);
  float shine = pow(max(dot(normal, normalize(kSun + to_eye)), 0.0), 48.0) * sun;
  float rim = pow(1.0 - max(dot(normal, to_eye), 0.0), 4.0);
  light += kSunLight * (part == 2 || part == 5 || by_value ? 0.05 : 0.28) * shine + kSkyLight * 0.06 * rim;
  light = mix(light, linear_of(horizon), (by_value ? 0.4 : 0.8) * fog(metres, eye.y));
  colour = vec4(encode(light), 1.0);
}
