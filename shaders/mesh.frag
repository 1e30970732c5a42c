// Warm sun and sky on painted steel; what lies on the other side of the ground than the eye is hidden by it.
uniform vec3 eye;
in vec3 world;
in vec3 facing;
flat in float material;
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

void main() {
  if (world.y * eye.y < 0.0) discard;
  int part = int(material + 0.5);
  vec3 normal = normalize(facing), to_eye = eye - world;
  float metres = length(to_eye);
  to_eye /= metres;
  float sun = max(dot(normal, kSun), 0.0);
  vec3 ambient = mix(kGroundLight, kSkyLight, 0.5 + 0.5 * normal.y);
  vec3 light = linear_of(paint(part)) * (kSunLight * sun + ambient);
  float shine = pow(max(dot(normal, normalize(kSun + to_eye)), 0.0), 48.0) * sun;
  float rim = pow(1.0 - max(dot(normal, to_eye), 0.0), 4.0);
  light += kSunLight * (part == 2 || part == 5 ? 0.05 : 0.28) * shine + kSkyLight * 0.06 * rim;
  light = mix(light, linear_of(kHorizonColour), 0.8 * fog(metres, eye.y));
  colour = vec4(encode(light), 1.0);
}
