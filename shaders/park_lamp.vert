// The glow of a lamp, turned to the eye; with STREAK its image on the water, drawn out towards the eye by waves.
layout(location = 0) in vec4 lamp;  // m; w: strength
uniform mat4 view_projection;
uniform vec3 eye, right, up;  // unit
uniform float pixel;          // m, its side at distance 1
uniform float water;          // m
out vec2 corner;
out float strength;

void main() {
  corner = vec2(float(gl_VertexID & 1), float(gl_VertexID >> 1)) * 2.0 - 1.0;
  strength = min(0.6 + 0.3 * lamp.w, 1.0);
#ifdef STREAK
  float over = lamp.y - water, eye_over = max(eye.y - water, 0.1);
  vec2 away = lamp.xz - eye.xz;
  vec2 at = eye.xz + away * (eye_over / (eye_over + max(over, 0.1)));
  float metres = max(length(away), 0.1), reach = 0.9 + 0.035 * metres;
  vec2 along = away / metres;
  vec3 place = vec3(at.x, water + 0.03, at.y) + corner.y * reach * vec3(along.x, 0.0, along.y) +
               corner.x * max(0.22, 1.2 * pixel * metres) * vec3(-along.y, 0.0, along.x);
  strength *= 0.6 * step(0.0, over);
#else
  vec3 to_eye = eye - lamp.xyz;
  float metres = length(to_eye), size = max(0.75 * sqrt(lamp.w), 2.6 * pixel * metres);
  vec3 place = lamp.xyz + to_eye / metres * 0.3 + size * (corner.x * right + corner.y * up);
#endif
  gl_Position = view_projection * vec4(place, 1.0);
}
