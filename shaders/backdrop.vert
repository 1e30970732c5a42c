// A part of the viewport, as a fan, with the ray direction of each pixel.
uniform vec2 corners[6];          // -1 to 1
uniform vec3 forward, right, up;  // right and up: to the viewport's edges at distance 1
out vec3 direction;
out vec2 across;  // -1 to 1

void main() {
  vec2 corner = corners[gl_VertexID];
  across = corner;
  direction = forward + corner.x * right + corner.y * up;
#ifdef BEHIND
  gl_Position = vec4(corner, 0.999999, 1.0);  // behind everything
#else
  gl_Position = vec4(corner, 0.0, 1.0);  // depth 0.5
#endif
}
