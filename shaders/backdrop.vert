// One triangle that covers the viewport, with the direction of sight for each pixel.
uniform vec3 forward, right, up;  // right and up: to the viewport's edges at distance 1
out vec3 direction;

void main() {
  vec2 corner = vec2(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0);
  direction = forward + corner.x * right + corner.y * up;
  gl_Position = vec4(corner, 1.0, 1.0);
}
